#!/bin/bash
# Tests what the program quad_layout returns and writes.
# usage: test_command.sh PROGRAM

set -uo pipefail
program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail()
{
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# usage: expect STATUS WORDS ARGUMENT...: the status, and an extended regular expression for stderr
expect()
{
  local status=$1 words=$2
  shift 2
  "$program" "$@" >stdout 2>stderr
  local got=$?
  [ $got = "$status" ] || fail "quad_layout $*: status $got instead of $status"
  [ -z "$words" ] || grep -Eq -- "$words" stderr || fail "quad_layout $*: \"$words\" is not in: $(cat stderr)"
  if [ "$status" != 0 ] && [ -n "$(find . -name '*.json' -o -name '*.part')" ]; then
    fail "quad_layout $*: has left files"
  fi
}

# A cube of n x n squares a side, two triangles each, as OFF.
cube()
{
  awk -v n="$1" '
    function vertex(x, y, z) {
      key = x " " y " " z
      if (!(key in number)) { number[key] = vertices; point[vertices++] = key }
      return number[key]
    }
    function at(side, axis, i, j) {
      if (axis == 0) return vertex(side, i, j)
      if (axis == 1) return vertex(j, side, i)
      return vertex(i, j, side)
    }
    BEGIN {
      vertices = 0; faces = 0
      for (axis = 0; axis < 3; ++axis) for (side = 0; side <= n; side += n)
        for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) {
          a = at(side, axis, i, j); b = at(side, axis, i + 1, j)
          c = at(side, axis, i + 1, j + 1); d = at(side, axis, i, j + 1)
          if (side == 0) { e = b; b = d; d = e }
          face[faces++] = a " " b " " c; face[faces++] = a " " c " " d
        }
      print "OFF"; print vertices, faces, 0
      for (v = 0; v < vertices; ++v) print point[v]
      for (f = 0; f < faces; ++f) print 3, face[f]
    }'
}

cube 8 >cube.off

# The cube with a parametrization: each side, seen from outside, is a chart.
awk 'BEGIN { v = 0 }
     NR > 2 && NF == 3 { x[v] = $1; y[v] = $2; z[v++] = $3; print "v", $0 }
     function chart(a, b, turned) { return turned ? "vt " b " " a : "vt " a " " b }
     NF == 4 {
       for (i = 2; i <= 4; ++i)
         if (x[$2] == x[$3] && x[$3] == x[$4]) print chart(y[$i], z[$i], x[$i] == 0)
         else if (y[$2] == y[$3] && y[$3] == y[$4]) print chart(z[$i], x[$i], y[$i] == 0)
         else print chart(x[$i], y[$i], z[$i] == 0)
       print "f " $2 + 1 "/-3 " $3 + 1 "/-2 " $4 + 1 "/-1"
     }' cube.off >charts.obj

# usage
expect 2 "no input"
expect 2 "unknown option --colour" cube.off --colour red
expect 2 "alpha needs a number" cube.off --alpha steep
expect 2 "alpha needs a value" cube.off --alpha
expect 2 "more than one input" cube.off cube.off
expect 2 "unknown solver" cube.off --solver oracle
expect 2 "time limit must be greater than 0" cube.off --time-limit 0
expect 2 "unknown field method" cube.off --field-method guess
expect 2 "unknown route" cube.off --route detour
expect 2 "exclude each other" charts.obj --parametrization charts.obj --field field.rosy
expect 2 "maximum_deviation" cube.off --alpha 200 --quiet
expect 2 "write-field needs a file" cube.off --write-field field.txt --quiet
expect 0 "" --help

# input that is refused, by the name of the element
expect 1 "no such file" absent.off
expect 1 "unknown format" cube.xyz
echo "no mesh" >broken.off
expect 1 "does not begin with OFF" broken.off
printf 'OFF\n1000000000000 1 0\n0 0 0\n' >short.off
expect 1 "too short for 1000000000000 of vertices" short.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-2 0 1 2\n' >corners.off
expect 1 "a face may announce too many corners" corners.off
printf 'OFF\n5 1 0\n0 8 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n5 0 1 2 3 4\n' >star.off
expect 1 "cannot remove all triangles without area" star.off --repair
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n' >letters.off
expect 1 "cannot be read" letters.off
printf 'ply\nformat ascii 1.0\nproperty float x\nelement vertex 0\nend_header\n' >order.ply
expect 1 "property before the first element" order.ply
ply_header() { # its properties of vertices
  printf 'ply\nformat ascii 1.0\nelement vertex 3\n'
  printf 'property %s\n' "$@"
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
}
{ ply_header 'int32 x' 'float y' 'float z'; printf '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'; } >integers.ply
expect 1 'property "x" of element "vertex" is of type "int32"' integers.ply
{ ply_header 'float x' 'float y'; printf '0 0\n1 0\n0 1\n3 0 1 2\n'; } >plane.ply
expect 1 'element "vertex" has no property "z"' plane.ply
{ ply_header 'float x' 'float y' 'float z' 'uchar red' 'float green' 'uchar g' 'uchar blue'
  printf '0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n'; } >colours.ply
expect 1 "colours of element \"vertex\" are of different types" colours.ply
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 2 3\n3 1 2 3\n' >turned.off
expect 1 "faces 0 and 2 .*vertex 0 to vertex 2.*orient_polygon_soup" turned.off
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 0 2\n' >twice.off
expect 1 "faces 0 and 2 have the same vertices.*merge_duplicate_polygons" twice.off
printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n' >wings.off
expect 1 "faces 0 and 1 and 1 more meet in the edge from vertex 0 to vertex 1" wings.off
printf 'OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n' >bow_tie.off
expect 1 "several fans of faces meet in vertex 0, one of them with face 1" bow_tie.off
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >square.off
expect 1 "face 0 has 4 sides.*--repair.*triangulate_faces" square.off
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >flat.off
expect 1 "face 0 .*has no area.*remove_degenerate_faces" flat.off
printf 'OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n' >pinched.off
expect 1 "face 1 has vertex 1 twice.*repair_polygon_soup" pinched.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >outside.off
expect 1 "." outside.off
printf 'OFF\n3 1 0\n0 0 0\n1e200 0 0\n0 1e200 0\n3 0 1 2\n' >huge.off
expect 1 "too large" huge.off --quiet
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 nan\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >nan.off
expect 1 "vertex 3 has a coordinate that is not a finite number|cannot be read" nan.off --quiet
echo "1 0 0" >short.txt
expect 1 "1 vectors for 768 faces" cube.off --field short.txt --quiet

echo "1" >short.rosy
expect 1 "line 1: the field has 1 faces, the mesh has 768" cube.off --field short.rosy --quiet
sed '0,/^vt 0 0$/s//vt 0.5 0/' charts.obj >torn.obj
expect 1 "not seamless: the sides of the edge" charts.obj --output torn --parametrization torn.obj
expect 1 "no such file" charts.obj --output torn --parametrization absent.obj

echo "x0 1" >wrong.sol
expect 1 "opposite sides of patches are not equally long" cube.off --read-solution wrong.sol --quiet
expect 1 "none.sol: no such file" cube.off --read-solution none.sol --quiet

# the time limit is for everything
cube 60 >fine.off
start=$SECONDS
expect 1 "not done within the time limit" fine.off --output late --time-limit 0.3
[ $((SECONDS - start)) -le 5 ] || fail "--time-limit 0.3 took $((SECONDS - start)) seconds"
[ ! -d late ] || fail "there are results of too little time"

# a layout
expect 0 "smooth" cube.off --output result --edge-length 0.05
if [ ! -d result ]; then
  fail "there are no results"
  exit 1
fi
for file in layout.obj layout_curves.obj quad_mesh.obj quad_mesh.vtp stats.json; do
  [ -s result/$file ] || fail "there is no result/$file"
done
[ -z "$(find result -name '*.part')" ] || fail "temporary files remain"
[ "$(grep -c '^g ' result/quad_mesh.obj)" = 6 ] || fail "a cube has six patches"
for key in input vertices faces euler components borders route singularities_in singularities_out patches \
           t_junctions quads bad_quads msj_min msj_avg patches_floor t_mesh nodes arcs traces program variables \
           constraints indicators objective bound gap status rounds map triangles inverted \
           wrong_winding seconds field trace quantize extract embed smooth total; do
  grep -q "\"$key\":" result/stats.json || fail "stats.json has no $key"
done
grep -q '"patches": 6,' result/stats.json || fail "stats.json does not say 6 patches"

# the other method for the field
expect 0 "" cube.off --output rounded --edge-length 0.05 --field-method mixed-integer --quiet
grep -q '"singularities_in": 8,' rounded/stats.json || fail "a rounded field on a cube has 8 singularities"

# the other route
expect 0 "" cube.off --output routed --edge-length 0.05 --route field --quiet
grep -q '"route": "field"' routed/stats.json || fail "the route is not the field"
grep -q '"route": "parametrization"' rounded/stats.json || fail "a cube has a parametrization"

# fields of other tools
for format in rosy rawfield ffield; do
  expect 0 "" cube.off --output by_$format --edge-length 0.05 --write-field field.$format --quiet
  expect 0 "" cube.off --output by_$format --edge-length 0.05 --field field.$format --quiet
  grep -q '"patches": 6,' by_$format/stats.json || fail "a field in .$format does not come back"
done
rm -r by_*

# a parametrization of another tool
expect 0 "" charts.obj --output charts --edge-length 0.05 --parametrization charts.obj --quiet
grep -q '"route": "parametrization"' charts/stats.json || fail "the given parametrization is not used"
grep -q '"patches": 6,' charts/stats.json || fail "the charts of a cube do not give its sides"
rm -r charts

# a surface with a border
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n' >open.off
expect 0 "smooth" open.off --output open --edge-length 0.05
grep -q '"borders": 1' open/stats.json || fail "stats.json does not say 1 border"

# what is refused above, repaired
for name in turned twice wings bow_tie square flat pinched; do
  expect 0 "smooth" $name.off --repair --output repaired_$name --edge-length 0.1
done
grep -q '"borders": 0' repaired_turned/stats.json || fail "the tetrahedron is not closed"
grep -q '"components": 2' repaired_bow_tie/stats.json || fail "the vertex is not duplicated"

# the program for other solvers
expect 0 "" cube.off --output result --edge-length 0.05 --write-program program.mps --quiet
[ "$(tail -n 1 program.mps)" = ENDATA ] || fail "the integer program is not complete"

# the other solvers, or that they are missing
for solver in cbc highs; do
  out=by_$solver
  if "$program" cube.off --solver $solver --output $out --edge-length 0.05 --quiet 2>stderr; then
    grep -q '"patches": 6,' $out/stats.json || fail "$out/stats.json does not say 6 patches"
  else
    grep -q "$solver is not built into this program" stderr ||
      fail "--solver $solver: $(cat stderr)"
  fi
done

if [ $failures = 0 ]; then
  echo "all well"
else
  echo "$failures failures"
  exit 1
fi
