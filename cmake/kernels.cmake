# The kernels, once for each instruction set. They are optimized in every build: without optimization functions of
# the standard library would be compiled for the wrong processor and could take the place of the ordinary ones.
# With the address sanitizer the wide ones take an hour to compile at -O2, and a step a hundred times as long at -O1:
# the preset leaves them out and checks the scalar ones, which are the same source.
set(FURNAS_WIDE_KERNELS_OPTIONS "" CACHE STRING "Further options of the kernels for AVX2 and AVX-512")

function(furnas_kernels set)
  add_library(furnas_kernels_${set} OBJECT ${PROJECT_SOURCE_DIR}/engine/kernels/all_kernels.cpp)
  target_compile_definitions(furnas_kernels_${set} PRIVATE FURNAS_KERNELS=kernels_for_${set})
  target_compile_options(furnas_kernels_${set} PRIVATE -O2 -fno-tree-vectorize ${ARGN}
                         # GCC 12 warns of its own AVX-512 intrinsics.
                         -Wno-maybe-uninitialized -Wno-uninitialized)
  target_sources(furnas_engine PRIVATE $<TARGET_OBJECTS:furnas_kernels_${set}>)
endfunction()

furnas_kernels(scalar)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  furnas_kernels(avx2 -march=x86-64-v3 -maes -mpclmul ${FURNAS_WIDE_KERNELS_OPTIONS})
  furnas_kernels(avx512 -march=skylake-avx512 ${FURNAS_WIDE_KERNELS_OPTIONS})
endif()
target_link_libraries(furnas_engine PRIVATE hwy::hwy)

furnas_headers(furnas_kernels_scalar ${furnas_kernel_headers})

# The test of what the objects may define.
function(furnas_test_kernels set)
  add_test(NAME Kernels.DefineNothingThatOthersDefine/${set}
           COMMAND ${CMAKE_COMMAND} -DNM=${CMAKE_NM} -DOBJECT=$<TARGET_OBJECTS:furnas_kernels_${set}>
                   -P ${PROJECT_SOURCE_DIR}/cmake/foreign_symbols.cmake)
  set_tests_properties(Kernels.DefineNothingThatOthersDefine/${set} PROPERTIES LABELS commit)
endfunction()
