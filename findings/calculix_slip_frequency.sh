#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): *FREQUENCY, PERTURBATION of a block on a base, pressed down, held by springs and
# pushed until it slips; contact NODE TO SURFACE with friction.
#
# Guess: small vibrations about the state that was reached stick, as in codes that take closed contact with friction as
#   sticking, so the first frequency is that before the push. Or else all of the contact slips, and it is that of the
#   springs, whatever the push. The manual says that friction may make frequencies complex, no more.
# Instead: a node has no tangential stiffness if the last iteration had it slipping, and rounding errors decide that as
#   much as the load. The first frequency is 78.5 kHz before, and 56.3 to 72.6 kHz, in no order, for pushes of 7 to
#   12 kN against a limit of 3 kN. A last step that takes 0.01 N off any of them returns 78.5 kHz. No message.
# Why it matters: tightening and assembling leave part of a contact slipping. What is then called the stiffness of the
#   joint, and compared with frequencies measured at small amplitudes, is that of the last increment.
# A way to live with it: a last static step with the loads a little reversed before *FREQUENCY, and the same frequencies
#   with twice the increments. A last step at the same load is not enough: at 6 kN it leaves 67.7 kHz.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

block() { # FIRST WIDTH BOTTOM TOP CELLS: nodes and elements of a layer that is square
  awk -v first="$1" -v width="$2" -v bottom="$3" -v top="$4" -v cells="$5" 'BEGIN {
    print "*NODE, NSET=ALL"
    side = cells + 1
    for (k = 0; k < 2; ++k) for (j = 0; j < side; ++j) for (i = 0; i < side; ++i)
      printf "%d, %.6f, %.6f, %.6f\n", first + i + side * (j + side * k), width * (i / cells - 0.5),
        width * (j / cells - 0.5), k ? top : bottom
    printf "*ELEMENT, TYPE=C3D8I, ELSET=BLOCK%d\n", first
    for (j = 0; j < cells; ++j) for (i = 0; i < cells; ++i) {
      n = first + i + side * j
      m = n + side * side
      print first + i + cells * j ", " n ", " n + 1 ", " n + side + 1 ", " n + side ", " m ", " m + 1 ", " \
        m + side + 1 ", " m + side
    }
    printf "*NSET, NSET=BOTTOM%d, GENERATE\n%d, %d\n", first, first, first + side * side - 1
    printf "*NSET, NSET=TOP%d, GENERATE\n%d, %d\n", first, first + side * side, first + 2 * side * side - 1
  }' </dev/null
}

frequency() { # LOAD…: the first frequency in kHz, after these tangential loads in N, one after another
  local load
  {
    block 1 10 0 5 2
    block 1001 14 -5 0 3
    cat <<END
*SURFACE, NAME=SLAVE, TYPE=ELEMENT
BLOCK1, S1
*SURFACE, NAME=MASTER, TYPE=ELEMENT
BLOCK1001, S2
*MATERIAL, NAME=STEEL
*ELASTIC
2.1E5, 0.3
*DENSITY
7.85E-9
*SOLID SECTION, ELSET=BLOCK1, MATERIAL=STEEL
*SOLID SECTION, ELSET=BLOCK1001, MATERIAL=STEEL
*ELEMENT, TYPE=SPRING1, ELSET=REST
2010, 10
2011, 11
2012, 12
2013, 13
2014, 14
2015, 15
2016, 16
2017, 17
2018, 18
*SPRING, ELSET=REST
1
5.E4
*SURFACE INTERACTION, NAME=JOINT
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR
1.E5
*FRICTION
0.3, 1.E4
*CONTACT PAIR, INTERACTION=JOINT, TYPE=NODE TO SURFACE
SLAVE, MASTER
*BOUNDARY
BOTTOM1001, 1, 3
ALL, 2
*STEP, NLGEOM, INC=1000
*STATIC
0.2, 1.
*DLOAD
BLOCK1, P2, 100.
*END STEP
END
    for load in "$@"; do
      printf '%s\n' "*STEP, NLGEOM, INC=1000" "*STATIC, DIRECT" "0.1, 1." "*CLOAD" \
        "TOP1, 1, $(awk "BEGIN { printf \"%.9f\", ($load) / 9 }" </dev/null)" "*END STEP"
    done
    printf '%s\n' "*STEP, PERTURBATION" "*FREQUENCY" 4 "*END STEP"
  } >block.inp
  ccx block >block.log || fail "ccx: $(grep -A 2 ERROR block.log)"
  ! grep -A 5 WARNING block.log | grep -q -i -e slip -e friction -e symm || fail "there is a warning of friction"
  awk '/E I G E N V A L U E   O U T P U T/ { table = 1 }
    /P A R T I C I P A T I O N/ { exit }
    table && NF == 4 && $1 ~ /^[0-9]+$/ && (!low || $3 < low) { low = $3 }
    table && NF == 5 && $1 ~ /^[0-9]+$/ && (!low || $4 < low) { low = $4 }
    END { printf "%.4g\n", low / 1000 }' block.dat
}

clamped="$(frequency 0)"
loaded=() reversed=()
for load in 7000 7500 8000 9000 10000 12000; do
  loaded+=("$(frequency "$load")")
  reversed+=("$(frequency "$load" "$load - 0.01")")
done
read -r low high < <(printf '%s\n' "${loaded[@]}" | sort -g | sed -n '1p;$p' | xargs)
read -r least most < <(printf '%s\n' "${reversed[@]}" | sort -g | sed -n '1p;$p' | xargs)
holds "$clamped > 78 && $clamped < 79" "before the push there are $clamped kHz"
holds "$high < 0.97 * $clamped && $low < 0.93 * $high" "slipping there are ${loaded[*]} kHz"
holds "$least > 0.998 * $clamped && $most < 1.002 * $clamped" "with 0.01 N less there are ${reversed[*]} kHz"
seen "kHz of the first mode: before $clamped, pushed by 7 to 12 kN ${loaded[*]}, with 0.01 N less ${reversed[*]};" \
  "6 kN and a step at the same load $(frequency 6000 6000)"
