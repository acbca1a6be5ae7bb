#!/bin/bash
# Runs the tests of a build; the last line says how many passed and failed.
# usage: run_ctest.sh BUILD [OPTION OF CTEST]...

set -uo pipefail
log=$(mktemp)
trap 'rm -f "$log"' EXIT
build=$1
shift

(cd "$build" && ctest --output-on-failure --parallel 2 "$@") 2>&1 | tee "$log"
summary='s/.*tests passed, \([0-9]*\) tests\{0,1\} failed out of \([0-9]*\).*/\1 \2/p'
read -r failed all < <(sed -n "$summary" "$log"; echo "1 1")
echo "$((all - failed)) passed, $failed failed"
[ "$failed" -eq 0 ]
