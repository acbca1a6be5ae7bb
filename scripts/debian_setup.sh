# What test/run_tests.sh, examples/run_demo.sh and .ci/run share. To be sourced by bash.
# shellcheck shell=bash

# Prints those of the given Debian packages that are not installed.
missing_packages()
{
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      printf '%s ' "$package"
  done
}

# Prints those of the given packages that this Debian has.
available_packages()
{
  local package
  for package in "$@"; do
    ! apt-cache show "$package" >/dev/null 2>&1 || printf '%s ' "$package"
  done
}

# Installs the given Debian packages as far as they are missing. Who may not do that is told the
# line to run.
require_packages()
{
  local missing
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ]; then
    echo "Some packages are missing. Please run"
    echo "  sudo apt-get install $missing"
    return 1
  fi >&2
  apt-get update -q
  # shellcheck disable=SC2086 # a list of words
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
}

# Prints the folder of CGAL's data, in which meshes/ is; unpacks it into folder $1 if need be.
# Prints nothing if there is no such data.
cgal_data()
{
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz
  if [ -n "${CGAL_DATA_DIR:-}" ]; then
    echo "$CGAL_DATA_DIR"
  elif [ -d "$1/data/meshes" ]; then
    echo "$1/data"
  elif [ -f "$archive" ]; then
    mkdir -p "$1"
    tar -xzf "$archive" -C "$1" data/meshes
    echo "$1/data"
  fi
}

# shellcheck disable=SC2034 # used where this file is sourced
build_packages="cmake make g++ libcgal-dev libcgal-demo libeigen3-dev libglpk-dev"
