#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): *FREQUENCY, STORAGE=YES and *STEADY STATE DYNAMICS of masses in a row on a base
# that shakes, as one tries a model of a joint before it goes into a large one.
#
# Guess: the modes of 12 masses, or a job that ends with an error. The manual gives no limit to the number of modes but
#   that of the model.
# Instead: 3 modes of 12 masses are 0 Hz. The job goes on, the mass at the end follows the base by exactly 1, whatever
#   the frequency, and it ends with "Job finished" and exit status 0. One line of its output has *ERROR in d[n,s]aupd:
#   the Lanczos method has more vectors than there are unknowns. 3 modes of 24 masses are right, 10 of 40 are 0 again.
# Why it matters: a transmissibility of 1 is what a stiff joint has. Scripts read the .dat file and the exit status.
# A way to live with it: fewer modes or more elements, some 5 unknowns for each mode; and scripts that look for *ERROR.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

row() { # MASSES MODES: status, lowest and highest frequency in Hz, motion of the last mass for 1 of the base at 5 Hz
  local masses="$1" modes="$2" status=0 i
  {
    echo "*NODE, NSET=ALL"
    for ((i = 0; i <= masses; ++i)); do echo "$((i + 1)), $((10 * i))., 0., 0."; done
    echo "*ELEMENT, TYPE=SPRINGA, ELSET=SPRINGS"
    for ((i = 1; i <= masses; ++i)); do echo "$i, $i, $((i + 1))"; done
    echo "*ELEMENT, TYPE=MASS, ELSET=MASSES"
    for ((i = 1; i <= masses; ++i)); do echo "$((i + 1000)), $((i + 1))"; done
    printf '%s\n' "*SPRING, ELSET=SPRINGS" "" 1000. "*MASS, ELSET=MASSES" 1.E-3 "*BOUNDARY" "ALL, 2, 3" "1, 1" "*STEP" \
      "*FREQUENCY, STORAGE=YES" "$modes" "*END STEP" "*STEP" "*STEADY STATE DYNAMICS" "5., 10., 2, 1." \
      "*MODAL DAMPING" "1, $modes, 0.02" "*BOUNDARY" "1, 1, 1, 1." "*NODE PRINT, NSET=ALL" U "*END STEP"
  } >row.inp
  rm -f row.dat
  ccx row >row.log || status=$?
  echo "$status" "$(awk -v last="$((masses + 1))" '
    /P A R T I C I P A T I O N/ { listed = 1 }
    !listed && NF == 5 && $1 ~ /^[0-9]+$/ { if (!($1 in seen)) frequency[++n] = $4; seen[$1] = 1 }
    /displacements/ { time = $NF }
    NF == 4 && $1 == last && time < 5.01 && motion == "" { motion = $2 }
    END { print frequency[1] + 0, frequency[n] + 0, motion }' row.dat)"
}

read -r status low high motion < <(row 12 3)
grep -q 'Job finished' row.log || fail "the job does not finish"
grep -q 'ERROR in d\[n,s\]aupd' row.log || fail "the line of the log is another: $(grep ERROR row.log)"
read -r status_long low_long high_long motion_long < <(row 24 3)
read -r _ low_many high_many _ < <(row 40 10)
right="$(awk 'BEGIN { pi = atan2(0, -1); x = 2 * pi * 5 / 2000; half = atan2(x, sqrt(1 - x * x))
  print cos(half) / cos(25 * half), cos(half) / cos(49 * half) }' </dev/null)"
read -r right_motion right_long <<<"$right"
[[ "$status $status_long" == "0 0" ]] || fail "the exit status is $status and $status_long"
holds "$low_long > 10.19 && $low_long < 10.21 && $high_long > 50.7 && $high_long < 50.9" \
  "24 masses have $low_long to $high_long Hz"
holds "$motion_long > 0.99 * $right_long && $motion_long < 1.01 * $right_long && $right_motion > 1.05" \
  "the last of 24 masses moves by $motion_long, not by $right_long"
holds "$high == 0 && $high_many == 0" "12 masses have $low to $high Hz, 40 have $low_many to $high_many Hz"
holds "$motion == 1" "the last of 12 masses moves by $motion"
seen "3 modes of 12 masses: $low to $high Hz, the last one moves by $motion (right: $right_motion); of 24: $low_long" \
  "to $high_long Hz, by $motion_long (right: $right_long); 10 modes of 40: $low_many to $high_many Hz"
