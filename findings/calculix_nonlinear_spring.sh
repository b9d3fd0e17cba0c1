#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): *SPRING, NONLINEAR (SPRINGA) in a *STATIC step without NLGEOM.
#
# Guess: the step iterates, as it does by itself for *PLASTIC, hyperelastic materials and contact. Four springs with 10
#   N/mm up to 1 mm and 100 N/mm beyond give way by 1.05 mm under 60 N and by 1.15 mm under 100 N. The manual lists
#   what makes a step nonlinear, without springs, and has nothing of NLGEOM under *SPRING.
# Instead: the step is linear with the stiffness at the start, without a message: 1.5 mm, where the curves have 240 N,
#   and 2.5 mm. A *FREQUENCY step after it takes the tangent at that place: beyond 2 mm, where the curve ends, it is 0,
#   and so is the frequency, which should be 100.7 Hz. With NLGEOM all are as they should be.
# Why it matters: curves of bolts, gaskets, mounts and measured backbones are put in as springs, small motions are no
#   reason for NLGEOM, and the first section of the curve is then all of it. Trials with small loads are right.
# A way to live with it: NLGEOM on each step; and the sum of the spring forces against the load.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

block() { # LOAD STEP: travel in mm, and the frequency in Hz after it, of a stiff block on four springs
  local load
  load="$(awk "BEGIN { print $1 / 4 }" </dev/null)"
  {
    cat <<END
*NODE, NSET=ALL
1, 0., 0., 0.
2, 10., 0., 0.
3, 10., 10., 0.
4, 0., 10., 0.
5, 0., 0., 10.
6, 10., 0., 10.
7, 10., 10., 10.
8, 0., 10., 10.
11, 0., 0., -50.
12, 10., 0., -50.
13, 10., 10., -50.
14, 0., 10., -50.
*NSET, NSET=FEET
11, 12, 13, 14
*NSET, NSET=TOP
5, 6, 7, 8
*ELEMENT, TYPE=C3D8, ELSET=BLOCK
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=SPRINGA, ELSET=SPRINGS
21, 1, 11
22, 2, 12
23, 3, 13
24, 4, 14
*MATERIAL, NAME=STIFF
*ELASTIC
1.E6, 0.
*DENSITY
1.E-6
*SOLID SECTION, ELSET=BLOCK, MATERIAL=STIFF
*SPRING, ELSET=SPRINGS, NONLINEAR

-110., -2.
-10., -1.
0., 0.
10., 1.
110., 2.
*BOUNDARY
ALL, 1, 2
FEET, 3
*STEP$2
*STATIC
0.25, 1.
*CLOAD
TOP, 3, $load
*NODE PRINT, NSET=TOP
U
*END STEP
*STEP, PERTURBATION
*FREQUENCY
1
*END STEP
END
  } >block.inp
  ccx block >block.log || fail "ccx: $(grep -A 2 ERROR block.log)"
  ! grep -A 4 WARNING block.log | grep -q -i -e spring -e linear || fail "there is a warning of springs"
  awk '/P A R T I C I P A T I O N/ { exit }
    NF == 4 && $1 == 5 && !table { travel = $4 }
    /E I G E N V A L U E   O U T P U T/ { table = 1 }
    table && NF == 5 && $1 == 1 { frequency = $4 }
    END { print travel, frequency }' block.dat
}

read -r travel frequency < <(block 60 "")
read -r far zero < <(block 100 "")
read -r right stiff < <(block 60 ", NLGEOM")
read -r right_far stiff_far < <(block 100 ", NLGEOM")
holds "$right > 1.049 && $right < 1.051 && $right_far > 1.149 && $right_far < 1.151" \
  "with NLGEOM the travel is $right and $right_far mm"
holds "$stiff > 100.5 && $stiff < 100.8 && $stiff_far > 100.5 && $stiff_far < 100.8" \
  "with NLGEOM the frequency is $stiff and $stiff_far Hz"
holds "$travel > 1.499 && $travel < 1.501 && $far > 2.499 && $far < 2.501" "the travel is $travel and $far mm"
holds "$frequency > 100 && $zero < 0.01" "the frequency is $frequency and $zero Hz"
seen "60 N and 100 N: $travel mm and $far mm, then $frequency Hz and $zero Hz; with NLGEOM $right mm and" \
  "$right_far mm, $stiff Hz and $stiff_far Hz"
