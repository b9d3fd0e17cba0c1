#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1) reads a number of 21 characters.
#
# Guess: 7.849999999999999e-09, which is what 7850 kg/m^3 becomes in t/mm^3 when a script multiplies by 1e-12 and writes
#   16 digits, is read as it stands, or refused.
# Instead: a field is cut after 20 characters, which takes the last digit of the exponent: e-0. The density is 7.85, the
#   job ends without a warning, and all frequencies are too low by the root of 1e9, 31623. A coordinate of
#   -1.00000000000000e+01 becomes -1. A number of 22 characters ends in "e-" and is refused.
# Why it matters: models are written by scripts. %.15e has 21 characters for every positive number, %.14e for every
#   negative one, and the shortest text that keeps a double has them often. Frequencies that are absurd are noticed; one
#   stiffness of a joint or one coordinate is not.
# A way to live with it: at most 13 digits after the point (%.13e has 19 characters, 20 with a sign).
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

frequency() { # DENSITY [X]: the first frequency in Hz, of a cube from there to 0
  cat >cube.inp <<END
*NODE, NSET=ALL
1, ${2:--10.}, 0., 0.
2, 0., 0., 0.
3, 0., 10., 0.
4, -10., 10., 0.
5, -10., 0., 10.
6, 0., 0., 10.
7, 0., 10., 10.
8, -10., 10., 10.
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=STEEL
*ELASTIC
2.1E5, 0.3
*DENSITY
$1
*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL
*BOUNDARY
1, 1, 3
2, 1, 3
3, 1, 3
4, 1, 3
*STEP
*FREQUENCY
2
*END STEP
END
  rm -f cube.dat
  ccx cube >cube.log || { echo refused && return; }
  ! grep -q -e WARNING -e ERROR cube.log || fail "there is a message: $(grep -A 2 -e WARNING -e ERROR cube.log)"
  awk '$1 == 1 && NF == 5 { print $4; exit }' cube.dat
}

written="$(awk 'BEGIN { printf "%.16g", 7850 * 1e-12 }' </dev/null)"
[[ "$written" == 7.849999999999999e-09 ]] || fail "7850 * 1e-12 is written as $written"
right="$(frequency 7.85e-09)"
cut="$(frequency "$written")"
longer="$(frequency 7.8499999999999993e-09)"
[[ "$longer" == refused ]] || fail "22 characters are read"
holds "$right > 6.5e4 && $right < 6.6e4" "the frequency of the cube is another"
holds "$right / $cut > 31600 && $right / $cut < 31650" "21 characters are read otherwise"
frequency 7.85e-09 -1.00000000000000e+01 >negative
x="$(awk '$1 == "2C" { nodes = 1; next } nodes && $2 ~ /^1-/ { print substr($0, 14, 12); exit }' cube.frd)"
holds "$x == -1" "the coordinate -10 of 21 characters is read as $x"
seen "7.85e-09 gives $right Hz, $written gives $cut Hz, 22 characters are refused; -1.00000000000000e+01 gives $x"
