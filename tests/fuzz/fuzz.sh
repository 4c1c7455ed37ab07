#!/bin/sh
# Fuzzes one parser: fuzz.sh TARGET SECONDS. Builds the targets with clang in build/fuzz; says 77 without clang.
# New inputs are kept in build/fuzz/corpus/TARGET; those that break the parser in build/fuzz/found.

set -eu

here=$(dirname -- "$(readlink -f -- "$0")")
root=$here/../..
build=$root/build/fuzz
target=$1

command -v clang++ >/dev/null 2>&1 || exit 77
echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
  clang++ -fsanitize=fuzzer -x c++ - -o /dev/null 2>/dev/null || exit 77

mkdir -p "$build/corpus/$target" "$build/found"
(
  flock 9
  cd "$root"
  cmake --preset fuzz && ninja -C "$build" "fuzz_$target"
) >"$build/$target.log" 2>&1 9>"$build/lock" || {
  tail -n 40 "$build/$target.log"
  exit 1
}
exec "$build/tests/fuzz_$target" "$build/corpus/$target" "$here/corpus/$target" -max_total_time="$2" -timeout=10 \
  -rss_limit_mb=1024 -malloc_limit_mb=512 -max_len=65536 -print_final_stats=1 -verbosity=0 \
  -artifact_prefix="$build/found/$target-"
