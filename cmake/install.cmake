# What `cmake --install` leaves for other people's C++: the libraries, their headers below include/furnas, where
# "engine/..." and "io/..." are found, and the package that find_package(furnas) reads.
include(CMakePackageConfigHelpers)
set(furnas_package ${CMAKE_INSTALL_LIBDIR}/cmake/furnas)
install(TARGETS furnas_engine furnas_io EXPORT furnas
        ARCHIVE COMPONENT library
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/furnas COMPONENT library)
install(EXPORT furnas NAMESPACE furnas:: FILE furnasTargets.cmake DESTINATION ${furnas_package} COMPONENT library)
# A minor version may change what headers say.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/furnasConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/furnasConfig.cmake ${PROJECT_BINARY_DIR}/furnasConfigVersion.cmake
        DESTINATION ${furnas_package} COMPONENT library)
