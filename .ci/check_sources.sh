#!/bin/bash
# Compiles sources, one at a time, with the given compiler and flags, and throws the code away.
# usage: check_sources.sh "SOURCE..." COMPILER FLAG...

set -uo pipefail
cd "$(dirname "$0")/.." || exit

read -r -a sources <<<"$1"
shift
if ! command -v "$1" >/dev/null; then
  echo "skipped: there is no $1"
  echo "0 passed, 0 failed"
  exit
fi

compile=("$@" -std=c++17 -Wall -Wextra -Werror -DBOOST_TEST_DYN_LINK
         -DCGAL_USE_GLPK -DCGAL_USE_CBC -DCGAL_EIGEN3_ENABLED -Iinclude -Itest
         -isystem /usr/include/eigen3 -isystem /usr/include/coin -isystem /usr/include/highs)
failures=$(mktemp)
trap 'rm -f "$failures"' EXIT
export failures
# shellcheck disable=SC2016 # expanded by the inner bash
printf '%s\n' "${sources[@]}" |
  xargs -P 2 -I SOURCE bash -c '"$@" SOURCE || echo SOURCE >>"$failures"' _ "${compile[@]}"

failed=$(wc -l <"$failures")
sed 's/^/does not compile: /' "$failures"
echo "$((${#sources[@]} - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
