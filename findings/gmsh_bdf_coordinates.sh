#!/usr/bin/env bash
# Gmsh 4.8.4 (gmsh 4.8.4+ds2-3): a bar in metres, saved as a mesh of Nastran (.bdf) and of Abaqus (.inp).
#
# Guess: fields of eight columns hold a coordinate as well as eight columns can: -0.01234560 as -.012346, by rounding.
# Instead: that is so of positive numbers. Of negative ones the sign takes a column and the last digit is cut off:
#   0.0123456 is 0.012346, and -0.0123456 is -0.01234, so that a bar that is symmetric about 0 no longer is.
# Why it matters: modes of a symmetric part split, mirrored halves do not meet within the tolerance of a merge, and holes
#   for bolts move by up to 10 um, the size of a clearance.
# A way to live with it: Mesh.BdfFieldFormat = 2, whose fields have 16 columns, or .inp; at least a model in millimetres.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian gmsh=4.8.4+ds2-3

cat >bar.geo <<'END'
Point(1) = {-0.0123456, 0, 0, 1};
Point(2) = {0.0123456, 0, 0, 1};
Line(1) = {1, 2};
END
for form in bdf inp; do
  gmsh -1 -format "$form" -o "bar.$form" bar.geo >gmsh.log 2>&1 || fail "gmsh: $(tail -n 1 gmsh.log)"
done
read -r left right < <(awk -F '' '/^GRID/ { x = substr($0, 25, 8); if (x < 0) low = x; else if (x > 0 && x > high) high = x }
  END { print low, high }' bar.bdf)
gmsh -1 -format bdf -setnumber Mesh.BdfFieldFormat 2 -o wide.bdf bar.geo >gmsh.log 2>&1 || fail "gmsh: $(tail -n 1 gmsh.log)"
grep -q -- "-0.0123456" wide.bdf || fail "wide fields have $(grep GRID wide.bdf | head -n 1)"
exact="$(awk -F ', *' '$1 == 2 && NF == 4 { print $2; exit }' bar.inp)"
holds "$exact > 0.01234559 && $exact < 0.01234561" "the .inp has $exact"
holds "$left == -0.01234 && $right == 0.012346" "the .bdf has $left and $right"
seen "the ends at -0.0123456 and 0.0123456 m are $left and $right m in the .bdf"
