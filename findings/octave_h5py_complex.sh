#!/usr/bin/env bash
# GNU Octave 7.3.0 (octave 7.3.0-2) loads complex numbers that h5py 3.7.0 (python3-h5py 3.7.0-8) has written to HDF5.
#
# Guess: complex numbers, or a structure of their two parts, or a message: both write a pair of doubles, h5py with
#   the names r and i, Octave with real and imag.
# Instead: an array of complex zeros of the right size, and no message. Real arrays of the same file are right.
#   Octave asks HDF5 for members real and imag, finds none, and leaves its memory as it was: cleared.
# Why it matters: frequency responses and modes that Python has computed are handed on so. A response of zeros shows,
#   but the imaginary part of an array that is mostly real, or one channel of many, is looked at by nobody.
# A way to live with it: write two real arrays; or in h5py a compound type with members real and imag.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian octave=7.3.0-2 python3-h5py=3.7.0-8

cat >write.py <<'END'
import h5py
import numpy as np

with h5py.File("response.h5", "w") as file:
    response = np.array([1 + 2j, 3 - 4j, 5j])
    file["response"] = response
    file["frequency"] = np.array([10.0, 20.0, 30.0])
    parts = np.zeros(3, dtype=[("real", "f8"), ("imag", "f8")])
    parts["real"], parts["imag"] = response.real, response.imag
    file["named"] = parts
END
python3 write.py || fail "h5py does not write"
cat >read.m <<'END'
file = load("response.h5");
printf("%d %d %g %g %g\n", iscomplex(file.response), numel(file.response), norm(file.response(:)), ...
       norm(file.frequency(:) - [10; 20; 30]), norm(file.named(:) - [1 + 2i; 3 - 4i; 5i]));
END
read -r complex count size frequencies named < <(octave read.m) || fail "Octave does not load it: $(cat octave.log)"
! grep -v "preparing to exit" octave.log | grep -q -i -e error -e warning ||
  fail "there is a message: $(cat octave.log)"
[[ "$frequencies" == 0 ]] || fail "real numbers are wrong, too"
[[ "$named" == 0 ]] || fail "a compound of real and imag is wrong, too"
[[ "$complex $count $size" == "1 3 0" ]] || fail "3 complex numbers arrive as $count with the norm $size"
seen "3 complex numbers of h5py have the norm $size in Octave; frequencies, and members named real and imag, are right"
