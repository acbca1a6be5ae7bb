#!/bin/bash
# Builds and runs all tests and examples; the last line says how many passed and failed.
# The folder of the build is the first argument, or build/.

set -euo pipefail
trap 'echo "0 passed, 1 failed"' ERR
cd "$(dirname "$0")/.."
source scripts/debian_setup.sh

# shellcheck disable=SC2086 # a list of words
require_packages $build_packages coinor-libcbc-dev libboost-test-dev libopenmesh-dev \
                 libsuitesparse-dev doxygen $(available_packages libhighs-dev) # not in Debian 12

build=${1:-build}
mkdir -p "$build"
build=$(cd "$build" && pwd)
data=$(cgal_data "$build/cgal_data")

# with all assertions, and optimized only so far that it pays: most of the time goes into compiling,
# for which reason all tests are compiled at a time, and so are all examples and all benchmarks
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
      -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 \
      -DCGAL_DATA_DIR="$data" -DQUAD_LAYOUTS_BUILD_BENCHMARKS=ON
# a program that does not compile is a test that fails
cmake --build "$build" --parallel 2 -- --keep-going || true

trap - ERR
scripts/run_ctest.sh "$build"
