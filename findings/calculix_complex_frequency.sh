#!/usr/bin/env bash
# CalculiX 2.20 (calculix-ccx 2.20-1): *COMPLEX FREQUENCY, CORIOLIS of a rotating beam with a damper at its tip.
#
# Guess: complex modes are there for what undamped modes leave out, so DASHPOTA elements count as in *STEADY STATE
#   DYNAMICS: the imaginary part of a frequency is its damping.
# Instead: the gyroscopic terms alone count. Every imaginary part is 0, without a message, while a steady-state step
#   of the same job has the damper: 2 % of critical damping at the peak of the first mode.
# Why it matters: under-platform and ring dampers of rotors are looked for in this very step; it says they do nothing.
# A way to live with it: the width of the peak of a *STEADY STATE DYNAMICS step, or mass and stiffness written by
#   *FREQUENCY, SOLVER=MATRIXSTORAGE and the damper added to them elsewhere.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian calculix-ccx=2.20-1

job() { # NAME LINE…: a beam that rotates about z, 100 to 300 mm from the axis, its modes, and a step of these lines
  local name="$1"
  shift
  {
    echo "*NODE, NSET=ALL"
    for ((i = 0; i <= 10; ++i)); do
      echo "$((4 * i + 1)), $((100 + 20 * i))., -5., -2."
      echo "$((4 * i + 2)), $((100 + 20 * i))., 5., -2."
      echo "$((4 * i + 3)), $((100 + 20 * i))., 5., 2."
      echo "$((4 * i + 4)), $((100 + 20 * i))., -5., 2."
    done
    echo "50, 300., 0., 50."
    echo "*ELEMENT, TYPE=C3D8I, ELSET=BEAM"
    for ((i = 0; i < 10; ++i)); do
      echo "$((i + 1)), $((4 * i + 1)), $((4 * i + 5)), $((4 * i + 6)), $((4 * i + 2)),"
      echo "$((4 * i + 4)), $((4 * i + 8)), $((4 * i + 7)), $((4 * i + 3))"
    done
    cat <<END
*ELEMENT, TYPE=DASHPOTA, ELSET=DAMPER
20, 43, 50
*DASHPOT, ELSET=DAMPER

3.5E-4
*MATERIAL, NAME=STEEL
*ELASTIC
2.1E5, 0.3
*DENSITY
7.85E-9
*SOLID SECTION, ELSET=BEAM, MATERIAL=STEEL
*NSET, NSET=TIP
43
*BOUNDARY
1, 1, 3
2, 1, 3
3, 1, 3
4, 1, 3
50, 1, 3
*STEP, NLGEOM
*STATIC
*DLOAD
BEAM, CENTRIF, 1.E4, 0., 0., 0., 0., 0., 1.
*END STEP
*STEP, PERTURBATION
*FREQUENCY, STORAGE=YES
4
*END STEP
*STEP, PERTURBATION
END
    printf '%s\n' "$@"
    echo "*END STEP"
  } >"$name.inp"
  ccx "$name" >"$name.log" || fail "ccx: $(grep -A 2 ERROR "$name.log")"
}


job complex "*COMPLEX FREQUENCY, CORIOLIS" 2
read -r rotation largest < <(awk '/IMAGINARY PART/ { ++table; next }
  table == 1 && $1 == 1 && NF == 5 && !rotation { rotation = $3 }
  table == 2 && ($1 == 1 || $1 == 2) && NF == 4 && $3 > 0 {
    imaginary = $4 < 0 ? -$4 : $4
    if (imaginary > largest) largest = imaginary
  }
  /P A R T I C I P A T I O N/ && table == 2 { exit }
  END { print rotation, largest + 0 }' complex.dat)
holds "$rotation > 500 && $rotation < 600" "the first mode is another"
holds "$largest < 1e-6 * $rotation" "an imaginary part is $largest rad/s"

job steady "*STEADY STATE DYNAMICS" "80., 95., 301, 1." "*CLOAD" "TIP, 3, 0.1" "*NODE PRINT, NSET=TIP" U
damping="$(awk '/displacements/ { time = $NF; next }
  $1 == 43 && !(time in real) { real[time] = $4; times[++n] = time; next }
  $1 == 43 { imaginary[time] = $4 }
  END {
    for (i = 1; i <= n; ++i) {
      power = real[times[i]] ^ 2 + imaginary[times[i]] ^ 2
      powers[i] = power
      if (power > peak) { peak = power; at = times[i] }
    }
    for (i = 1; i <= n; ++i) if (powers[i] > peak / 2) { if (!low) low = times[i]; high = times[i] }
    print (high - low) / 2 / at
  }' steady.dat)"
holds "$damping > 0.015 && $damping < 0.025" "the steady state has a damping of $damping"
seen "the largest imaginary part is $largest rad/s at $rotation rad/s, the steady state has a damping ratio of $damping"
