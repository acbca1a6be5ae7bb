#!/bin/bash
# Computes the layout of a mesh, prints what came out and draws it.
# usage: examples/run_demo.sh [MESH [FOLDER]]
# MESH is refined_elephant.off out of CGAL's data if not given, FOLDER is result/.

set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
source "$root/scripts/debian_setup.sh"

# shellcheck disable=SC2086 # a list of words
require_packages $build_packages python3

build=$root/build/demo
mkdir -p "$build"
data=$(cgal_data "$root/build/cgal_data")
mesh=${1:-$data/meshes/refined_elephant.off}
folder=${2:-$root/result}

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DQUAD_LAYOUTS_BUILD_TESTS=OFF \
      -DCGAL_DATA_DIR="$data" >/dev/null
cmake --build "$build" --target quad_layout
"$build/examples/quad_layout" "$mesh" --output "$folder"

python3 - "$folder/stats.json" <<'PRINT_TABLE'
import json, sys

stats = json.load(open(sys.argv[1]))
rows = [("triangles of the input", stats["input"]["faces"]),
        ("singularities of the field", stats["singularities_in"]),
        ("irregular vertices of the layout", stats["singularities_out"]),
        ("patches of the layout", stats["patches"]),
        ("least possible for these vertices", stats["patches_floor"]),
        ("T-junctions", stats["t_junctions"]),
        ("quads of the mesh", stats["quads"]),
        ("scaled Jacobian, least", f'{stats["msj_min"]:.3f}'),
        ("scaled Jacobian, average", f'{stats["msj_avg"]:.3f}'),
        ("seconds", f'{stats["seconds"]["total"]:.1f}')]
print()
for name, value in rows:
    print(f"{name:34} {value:>9}")
print()
PRINT_TABLE
echo "The layout, the quad mesh and stats.json are in $folder."

# The picture needs packages that the library does not.
require_packages python3-vtk9 python3-numpy xvfb xauth || true
if "$root/examples/render_layout.sh" "$folder" "$folder/layout.png"; then
  echo "The picture is $folder/layout.png."
else
  echo "There is no picture: the packages to draw it are missing."
fi
