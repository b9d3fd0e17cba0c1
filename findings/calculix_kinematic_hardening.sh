#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): a cube with *PLASTIC, HARDENING=KINEMATIC, pulled and then cycled.
#
# Guess: pulled once, beyond yield at 200 MPa along the line to 400 MPa at a plastic strain of 1 %, it follows the
#   hardening curve, 254.5 MPa at a strain of 0.4 %, since isotropic and kinematic hardening differ after a reversal
#   only. Cycles of +-0.4 %, with plastic strains below 0.3 %, are closed loops of a Masing model.
# Instead: in a step without NLGEOM it softens. After 203 MPa the stress falls at the rate of a hardening of the
#   opposite sign, to 143 MPa, and further with smaller increments; isotropic hardening gives 254.5 MPa. With NLGEOM it
#   is 253.6 MPa, as it should be; but the second peak is 181 MPa, for the place on the curve is the plastic strain that
#   all cycles add up to, and the curve ends at 1 %. No message in either case, and the balance of energy holds.
# Why it matters: hardening solids in parallel are how a joint with microslip is put into a finite-element model, and
#   small strains are no reason to ask for NLGEOM. Stiffness, loss and macro-slip of the loop are wrong, and change
#   from cycle to cycle.
# A way to live with it: NLGEOM on the step, a hardening curve that goes on, straight, beyond the plastic strain of all
#   cycles together, and a pull and two cycles of one element before a model of a joint.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

peaks() { # HARDENING STEP [END]: the stress in MPa at a strain of 0.4 %, at first and a cycle later
  cat >cube.inp <<END
*NODE, NSET=ALL
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
*NSET, NSET=TOP
5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=CUBE
1, 1, 2, 3, 4, 5, 6, 7, 8
*MATERIAL, NAME=STEEL
*ELASTIC
2.E5, 0.3
*PLASTIC, HARDENING=$1
200., 0.
${3:-400., 0.01}
*SOLID SECTION, ELSET=CUBE, MATERIAL=STEEL
*BOUNDARY
1, 1, 3
2, 2, 3
3, 3
4, 1
4, 3
*AMPLITUDE, NAME=CYCLES
0., 0., 1., 1., 3., -1., 5., 1.
*STEP, INC=1000$2
*STATIC, DIRECT
0.05, 5.
*BOUNDARY, AMPLITUDE=CYCLES
TOP, 3, 3, 0.004
*NODE PRINT, NSET=TOP, TOTALS=ONLY
RF
*END STEP
END
  ccx cube >cube.log || fail "ccx: $(grep -A 2 ERROR cube.log)"
  ! grep -q WARNING cube.log || fail "there is a warning: $(grep -A 2 WARNING cube.log)"
  awk '/total force/ { time = $NF }
    NF == 3 && /E/ { last = $3; if (time < 1.01) first = $3 }
    END { print first, last }' cube.dat
}

read -r isotropic _ < <(peaks ISOTROPIC "")
read -r softened _ < <(peaks KINEMATIC "")
read -r large later < <(peaks KINEMATIC ", NLGEOM")
read -r _ continued < <(peaks KINEMATIC ", NLGEOM" "20200., 1.")
holds "$isotropic > 254 && $isotropic < 255" "isotropic hardening gives $isotropic"
holds "$softened > 130 && $softened < 150" "kinematic hardening without NLGEOM gives $softened"
holds "$large > 253 && $large < 255" "kinematic hardening with NLGEOM gives $large"
holds "$later > 170 && $later < 190" "kinematic hardening with NLGEOM gives $later in the second cycle"
holds "$continued > 253 && $continued < 255" "with a curve that goes on, it gives $continued in the second cycle"
seen "in MPa: isotropic $isotropic; kinematic $softened; with NLGEOM $large, a cycle later $later," \
  "with a longer curve $continued"
