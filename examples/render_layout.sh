#!/bin/bash
# Draws the quad mesh that the program quad_layout wrote.
# usage: examples/render_layout.sh FOLDER PICTURE.png [--view X,Y,Z] [--up X,Y,Z]
# It needs the Debian packages python3-vtk9, python3-numpy, xvfb and xauth, but no screen.

set -euo pipefail
if [ $# -lt 2 ]; then
  sed -n '2,4s/^# //p' "$0" >&2
  exit 2
fi
if ! command -v xvfb-run >/dev/null || ! /usr/bin/python3 -c 'import numpy, vtkmodules' 2>/dev/null; then
  echo "render_layout.sh needs the packages python3-vtk9, python3-numpy, xvfb and xauth" >&2
  exit 1
fi
# Debian's python3 is named by its path: VTK is installed for no other one
exec xvfb-run -a -s "-screen 0 1280x1024x24" \
     /usr/bin/python3 "$(dirname "$0")/render_layout.py" "$@"
