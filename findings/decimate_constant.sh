#!/usr/bin/env bash
# SciPy 1.10.1 (python3-scipy 1.10.1-2) and GNU Octave 7.3.0 with its signal package 1.4.3 (octave-signal 1.4.3-1):
# decimate of a constant and of slow sines.
#
# Guess: a low-pass filter leaves a constant as it is, and slow sines with it; the ripple is in the upper part of the
#   band. The documentation of both names the filter, Chebyshev of type I and order 8, and not its ripple.
# Instead: a constant of 1 becomes 0.98855, in both. A Chebyshev filter of even order has its ripple at 0 Hz, too,
#   0.05 dB here, and it is applied forwards and backwards. Sines come out between 0.9886 and 1, by their frequency.
#   With "fir" a constant stays.
# Why it matters: a static deflection or a preload is 1.1 % smaller than before, and the loss per cycle, force times
#   displacement, 2.3 % at one frequency and 0 % at another, which looks like a joint that depends on frequency.
# A way to live with it: ftype="fir", or "fir" in Octave.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-scipy=1.10.1-2 octave=7.3.0-2 octave-signal=1.4.3-1

cat >slow.py <<'END'
import numpy as np
from scipy import signal

times = np.arange(40000) / 1000


def middle(samples, **options):
    return signal.decimate(samples, 10, **options)[1000:3000]


def amplitude(frequency):
    decimated = middle(np.sin(2 * np.pi * frequency * times))
    late = times[::10][1000:3000]
    basis = np.column_stack([np.sin(2 * np.pi * frequency * late), np.cos(2 * np.pi * frequency * late)])
    return np.hypot(*np.linalg.lstsq(basis, decimated, rcond=None)[0])


constant = middle(np.ones(40000))
assert np.ptp(constant) < 1e-9
print(constant[0], middle(np.ones(40000), ftype="fir")[0], amplitude(0.5), amplitude(10))
END
cat >slow.m <<'END'
warning("off", "all");
for folder = {"/usr/share/octave/packages", fullfile(getenv("ROOT"), "usr/share/octave/packages")}
  addpath(genpath(folder{1}));
end
y = decimate(ones(40000, 1), 10);
z = decimate(ones(40000, 1), 10, "fir");
printf("%.6f %.6f\n", y(2000), z(2000));
END
python3 slow.py >scipy.txt 2>scipy.log || fail "SciPy: $(tail -n 1 scipy.log)"
read -r iir fir slow faster <scipy.txt
read -r iir_octave fir_octave < <(ROOT="$root" octave slow.m) || fail "Octave does not run it: $(cat octave.log)"
holds "$fir > 0.9999 && $fir < 1.0001 && $fir_octave > 0.9999 && $fir_octave < 1.0001" \
  "with fir a constant becomes $fir and $fir_octave"
holds "$iir > 0.9885 && $iir < 0.9886 && $iir_octave > 0.9885 && $iir_octave < 0.9886" \
  "a constant becomes $iir in SciPy and $iir_octave in Octave"
holds "$slow < 0.989 && $faster > 0.997 && $faster < 1.001" "sines at 0.5 and 10 Hz become $slow and $faster"
seen "from 1000 to 100 Hz a constant of 1 becomes $iir in SciPy and $iir_octave in Octave, a sine at 0.5 Hz $slow and" \
  "one at 10 Hz $faster"
