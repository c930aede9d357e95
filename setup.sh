#!/usr/bin/env bash
# Installs what packstone needs on Debian 12, builds it, and runs the demo, the tests, the benchmark or nothing more.
# Safe to repeat: what is there already is kept.
set -euo pipefail
cd "$(dirname "$0")"

usage="usage: ./setup.sh [build|demo|test [OPTION...]|sanitize [threads]|bench [OPTION...]]
  build  install the packages and build build/packstone (the default)
  demo   build, then run sample 01 from the scene to the report
  test   build, then run the tests, then those of the readers and writers under AddressSanitizer and
         UndefinedBehaviorSanitizer; with options, which go to ctest, the first alone: -C long -L long runs those of minutes
  sanitize  build without VTK, then run all tests under AddressSanitizer and UndefinedBehaviorSanitizer;
         threads: those of the engine and of measures under ThreadSanitizer
  bench  install LAMMPS and LIGGGHTS too, then run the same beds through all three;
         \`./setup.sh bench --help\` has the options, tests/bench/README.md the rest"

build_packages=(g++ make cmake ninja-build git ca-certificates)
library_packages=(libeigen3-dev libhdf5-dev libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
                  libmuparser-dev voro++-dev libvtk9-dev libosmesa6-dev libegl-dev libisal-dev
                  libcairo2-dev libopenmpi-dev)
program_packages=(ffmpeg openmpi-bin libegl1 fontconfig fonts-dejavu-core)
test_packages=(catch2 python3-h5py voro++ poppler-utils locales)
clang_packages=(clang libomp-dev)  # for fuzzing and ThreadSanitizer
bench_packages=(lammps liggghts libbenchmark-dev)

say() { printf '\n== %s\n' "$*"; }

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
  local missing=()
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi
  say "installing ${missing[*]}"
  as_root apt-get update
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

build() {
  install_packages "${build_packages[@]}" "${library_packages[@]}" "${program_packages[@]}" "${test_packages[@]}"
  say "configuring and building in build/"
  cmake --preset default -DPACKSTONE_TESTS="$1" -DCMAKE_UNITY_BUILD=ON  # half the time of a build from nothing
  cmake --build build
}

demo() {
  build OFF
  say "running sample 01_density_segregation"
  ./samples/01_density_segregation/run.sh build/packstone runs/01_density_segregation
}

run_tests() {
  build ON
  say "running the tests"
  (cd build && ctest --output-on-failure --parallel 2 "$@")
  if [ $# -gt 0 ]; then return; fi
  # With them a fresh clone takes 13 minutes on two cores; a machine that is slower is to be done in 15, too.
  if [ $SECONDS -lt 600 ]; then
    sanitize sanitize test_core test_fuzz
  else
    say "no time left for the sanitizers: ./setup.sh sanitize runs them"
  fi
}

# sanitize PRESET TARGET... builds these tests and runs them.
sanitize() {
  say "building ${*:2} for the preset $1"
  cmake --preset "$1" -DCMAKE_UNITY_BUILD=ON
  cmake --build --preset "$1" --target "${@:2}"
  say "running ${*:2}"
  # A process that tries a file is silent, and what it dies of passes for damage to the file: reports go to files. It
  # is there for HDF5's own faults, so those are none of ours.
  local findings="$PWD/build-$1/findings" failed=0
  rm -rf "$findings"
  mkdir "$findings"
  export ASAN_OPTIONS="log_path=$findings/asan" UBSAN_OPTIONS="print_stacktrace=1"
  (cd "build-$1" && ctest --output-on-failure --parallel 2 --no-tests=error \
    --tests-regex "^($(printf '%s|' "${@:2}" | sed 's/test_//g; s/|$//')):") || failed=1
  local ours
  mapfile -t ours < <(grep -rL libhdf5 "$findings")
  if [ ${#ours[@]} -gt 0 ]; then
    cat "${ours[@]}"
    failed=1
  fi
  return $failed
}

run_sanitized() {
  install_packages "${build_packages[@]}" "${library_packages[@]}" "${program_packages[@]}" "${test_packages[@]}"
  case "${1:-}" in
    "") sanitize sanitize test_core test_engine test_analysis test_format test_fuzz test_cli ;;
    threads)
      install_packages "${clang_packages[@]}"
      archer=$(find /usr/lib/llvm-*/lib -name libarcher.so | head -1)
      export OMP_TOOL_LIBRARIES=$archer TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1"
      sanitize sanitize-threads test_engine test_analysis
      ;;
    *) echo "$usage" >&2; exit 2 ;;
  esac
}

run_benchmark() {
  build OFF
  install_packages "${bench_packages[@]}"
  say "running the benchmark beside LAMMPS and LIGGGHTS"
  tests/bench/peers/bench.py "$@"
}

case "${1:-build}" in
  build) build OFF ;;
  demo) demo ;;
  test) run_tests "${@:2}" ;;
  sanitize) run_sanitized "${@:2}" ;;
  bench) run_benchmark "${@:2}" ;;
  -h|--help) echo "$usage" ;;
  *) echo "$usage" >&2; exit 2 ;;
esac
