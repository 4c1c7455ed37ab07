#pragma once

#include <string>
#include <string_view>

#if __has_include(<gnu/libc-version.h>)
#include <gnu/libc-version.h>
#endif

namespace furnas::test {

/// What has a share in the bits of a run besides furnas: the compiler, the C library with its exponential
/// function, and the family of processors.
struct Machine {
  std::string compiler, c_library, architecture;
};

/// The hashes of a release are made here, and asserted nowhere else.
inline const Machine release_machine{
    .compiler = "g++ 12", .c_library = "glibc 2.36", .architecture = "x86-64"};

/// The first `count` numbers of a version: "2.36" of "2.36.9000" for two.
inline std::string leading_numbers(std::string_view version, int count) {
  std::size_t end = 0;
  for (int n = 0; n < count && end != std::string_view::npos; ++n)
    end = version.find_first_not_of("0123456789", n == 0 ? 0 : end + 1);
  return std::string(version.substr(0, end));
}

inline Machine this_machine() {
#if defined(__clang__)
  const std::string compiler = "clang++ " + leading_numbers(__clang_version__, 1);
#else
  const std::string compiler = "g++ " + leading_numbers(__VERSION__, 1);
#endif
#if __has_include(<gnu/libc-version.h>)
  const std::string c_library = "glibc " + leading_numbers(::gnu_get_libc_version(), 2);
#else
  const std::string c_library = "another C library";
#endif
#if defined(__x86_64__)
  const char* architecture = "x86-64";
#elif defined(__aarch64__)
  const char* architecture = "ARM64";
#else
  const char* architecture = "another architecture";
#endif
  return {.compiler = compiler, .c_library = c_library, .architecture = architecture};
}

/// A sentence that names what differs; empty if nothing does.
inline std::string difference(const Machine& here, const Machine& there) {
  std::string differs;
  const auto compare = [&](const std::string& a, const std::string& b) {
    if (a != b) differs += (differs.empty() ? "" : ", ") + a + " instead of " + b;
  };
  compare(here.compiler, there.compiler);
  compare(here.c_library, there.c_library);
  compare(here.architecture, there.architecture);
  if (differs.empty()) return {};
  return "The hashes of the release were made on another machine; here is " + differs + ".";
}

inline std::string difference_from_release_machine() { return difference(this_machine(), release_machine); }

}  // namespace furnas::test
