#!/usr/bin/env bash
# Installs what packstone needs on Debian 12, builds it, and runs the demo, the tests, the benchmark or nothing more.
# Safe to repeat: what is there already is kept.
set -euo pipefail
cd "$(dirname "$0")"

usage="usage: ./setup.sh [build|demo|test [OPTION...]|bench [OPTION...]]
  build  install the packages and build build/packstone (the default)
  demo   build, then run sample 01 from the scene to the report
  test   build, then run the tests; options go to ctest: -C long -L long runs those of minutes instead
  bench  install LAMMPS and LIGGGHTS too, then run the same beds through all three;
         \`./setup.sh bench --help\` has the options, tests/bench/README.md the rest"

build_packages=(g++ make cmake ninja-build git ca-certificates)
library_packages=(libeigen3-dev libhdf5-dev libfmt-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
                  libmuparser-dev voro++-dev libvtk9-dev libosmesa6-dev libegl-dev libisal-dev
                  libcairo2-dev libopenmpi-dev)
program_packages=(ffmpeg openmpi-bin libegl1 fontconfig fonts-dejavu-core)
test_packages=(catch2 python3-h5py voro++ poppler-utils locales)
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
  bench) run_benchmark "${@:2}" ;;
  -h|--help) echo "$usage" ;;
  *) echo "$usage" >&2; exit 2 ;;
esac
