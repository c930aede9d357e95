#!/usr/bin/env bash
# Fuzzes every reader for so many seconds each, or the named ones: tests/fuzz/run.sh SECONDS [TARGET...]
# What is found stays in build-fuzz/findings/TARGET, beside inputs on which a trial died as it may; put a small one into
# tests/fuzz/regressions/TARGET once it is mended.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [TARGET...]}
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz
program=build-fuzz/fuzz_readers
targets=("${@:2}")
if [ ${#targets[@]} -eq 0 ]; then mapfile -t targets < <("$program"); fi
failed=()
for target in "${targets[@]}"; do
  corpus=build-fuzz/corpus/$target findings=build-fuzz/findings/$target
  mkdir -p "$corpus" "$findings"
  echo "== $target"
  if ! PACKSTONE_FUZZ_TARGET=$target PACKSTONE_FUZZ_SEEDS=$corpus "$program" "$corpus" \
    -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=512 -max_len=65536 \
    -artifact_prefix="$findings/" -print_final_stats=1 >"$findings.log" 2>&1; then
    failed+=("$target")
  fi
  grep -E '^stat|SUMMARY|what\(\)' "$findings.log" | tail -8
done
if [ ${#failed[@]} -gt 0 ]; then
  echo "findings of: ${failed[*]}" >&2
  exit 1
fi
