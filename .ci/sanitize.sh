#!/bin/bash
# Runs the tests with sanitizers, but for those that take very long with them. CGAL's data are left
# out, and CBC, which is found by PkgConfig.

set -uo pipefail
cd "$(dirname "$0")/.." || exit

build=$PWD/build/sanitize
# The checks of pointers by the undefined behaviour sanitizer take long to compile, and find little that
# the address sanitizer does not.
flags=(-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined
       -fno-sanitize=alignment,null,object-size,pointer-overflow,vptr)
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="${flags[*]}" -DCGAL_DATA_DIR= \
      -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=18 \
      -DQUAD_LAYOUTS_TESTS_LEFT_OUT='test_(quantize_exhaustively|quantize_wishes|quad_remesh)' \
      -DQUAD_LAYOUTS_BUILD_EXAMPLES=OFF -DQUAD_LAYOUTS_BUILD_DOC=OFF \
      -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON >/dev/null || exit 1
cmake --build "$build" --parallel 2 --target all_tests -- --keep-going || true

# GLPK keeps its environment until the thread ends.
export ASAN_OPTIONS=detect_leaks=0
unset CGAL_DATA_DIR
scripts/run_ctest.sh "$build" --tests-regex '^test_'
