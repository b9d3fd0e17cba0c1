#!/usr/bin/env bash
# GNU Octave 7.3.0 (octave 7.3.0-2) loads whole numbers that savemat of SciPy 1.10.1 (python3-scipy 1.10.1-2) has
# written.
#
# Guess: numbers are numbers: 1000 becomes the 1000 of Octave, a double, as it does from a text file.
# Instead: NumPy makes whole numbers int64, savemat keeps that, and Octave gives every product with an int64 the same
#   type and rounds it. A stiffness of 1000 N/m times displacements up to 0.4 mm is 0 N, its energy is 0 J, Rayleigh
#   damping 2e-4 * K is 0, and (0:n-1)/n of n = 5 samples is 0 0 0 1 1. No message; sqrt works, eig refuses. The
#   documentation of savemat says nothing of types.
# Why it matters: stiffness, mass, number of samples and sampling rate are whole numbers in the scripts that make test
#   models. A damping or a loss of exactly 0 is a model that has none, and the same script is right with 1000.5 N/m.
# A way to live with it: numpy.asarray(value, float) of all that savemat gets; or double() of all that load returns.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2 python3-scipy=1.10.1-2

cat >write.py <<'END'
import numpy as np
from scipy.io import savemat

model = {"k": 1000, "n": 5, "K": np.array([[2, -1], [-1, 1]]) * 1000}
savemat("whole.mat", model)
savemat("double.mat", {name: np.asarray(value, float) for name, value in model.items()})
END
python3 write.py || fail "SciPy does not write"
cat >read.m <<'END'
for name = {"whole.mat", "double.mat"}
  m = load(name{1});
  x = (0:4) * 1e-4;
  printf("%s %g %g %g %g\n", class(m.k), max(m.k * x), 0.5 * max(m.k * x.^2), max(abs((2e-4 * m.K)(:))), ...
         max(abs(double((0:m.n-1) / m.n) - (0:4) / 5)));
end
END
octave read.m >read.txt
! grep -q -i warning octave.log || fail "there is a warning: $(cat octave.log)"
{
  read -r type force energy damping time
  read -r right_type right_force right_energy right_damping right_time
} <read.txt || fail "Octave does not run it: $(cat octave.log)"
[[ "$right_type $right_force $right_energy $right_damping" == "double 0.4 8e-05 0.4" ]] ||
  fail "doubles give $right_force N, $right_energy J, $right_damping"
holds "$right_time < 1e-12" "doubles give times off by $right_time"
[[ "$type $force $energy $damping" == "int64 0 0 0" ]] || fail "a $type gives $force N, $energy J, $damping"
holds "$time > 0.35" "times are off by $time"
seen "a force of 0.4 N is $force N, an energy of 8e-05 J $energy J, a damping of 0.4 $damping, times are off by $time"
