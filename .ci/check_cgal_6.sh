#!/bin/bash
# Checks sources against the headers of CGAL 6, out of the package of a newer Debian.
# usage: check_cgal_6.sh "SOURCE..."

set -uo pipefail
cd "$(dirname "$0")/.." || exit

folder=$PWD/build/cgal_6
if [ ! -d "$folder/usr/include/CGAL" ]; then
  mkdir -p "$folder"/{lists,cache/archives}/partial
  key=/usr/share/keyrings/debian-archive-keyring.gpg
  echo "deb [signed-by=$key] http://deb.debian.org/debian trixie main" >"$folder/sources.list"
  apt=(apt-get -q -o Dir::Etc::SourceList="$folder/sources.list" -o Dir::Etc::SourceParts=-
       -o Dir::State::Lists="$folder/lists" -o Dir::Cache="$folder/cache" -o APT::Sandbox::User=root)
  (cd "$folder" && "${apt[@]}" update && "${apt[@]}" download libcgal-dev) &&
    dpkg-deb -x "$folder"/libcgal-dev_*.deb "$folder"
fi

if [ ! -d "$folder/usr/include/CGAL" ]; then
  echo "skipped: the headers of CGAL 6 cannot be had here"
  echo "0 passed, 0 failed"
  exit
fi
compiler=$(command -v clang++ || echo g++) # clang takes less than half the time
.ci/check_sources.sh "$1" "$compiler" -fsyntax-only -isystem "$folder/usr/include"
