#!/bin/bash
# Runs the unit tests with sanitizers, without CGAL's data: what needs a large mesh is skipped.

set -uo pipefail
cd "$(dirname "$0")/.." || exit

build=build/sanitize
# GCC takes checked values for uninitialized ones.
flags="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined -Wno-maybe-uninitialized"
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" -DCGAL_DATA_DIR= \
      -DQUAD_LAYOUTS_BUILD_EXAMPLES=OFF -DQUAD_LAYOUTS_BUILD_DOC=OFF >/dev/null || exit 1
cmake --build "$build" --parallel 2 -- --keep-going || true

# GLPK keeps its environment until the thread ends.
export ASAN_OPTIONS=detect_leaks=0
unset CGAL_DATA_DIR
passed=0
failed=0
for source in test/test_*.cpp; do
  if "$build/${source%.cpp}"; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
