#!/usr/bin/env bash
# SoX 14.4.2 (sox 14.4.2+git20190427-3.5): "sox in.wav out.wav trim …" of a WAV file of floating-point numbers.
#
# Guess: floating-point numbers in, the same numbers out; trim changes no sample.
# Instead: samples pass through integers and come out as multiples of 2^-24, which is 6e-8, however small they
#   are. A displacement in metres with an amplitude of 1e-6 has 35 values left, one of 2e-8 is all
#   zeros. SoX says nothing. (What is above 1 is clipped; of that it warns.)
# Why it matters: displacements in metres are 1e-9 to 1e-6, and cutting a recording is what SoX is used for.
#   The steps look like those of a coarse converter and make harmonics of their own.
# A way to live with it: scale to 1 before the recording becomes WAV and note the factor; cut by other means, for
#   example scipy.io.wavfile, which keeps the numbers.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian sox=14.4.2+git20190427-3.5 python3-scipy=1.10.1-2

cat >write.py <<'END'
import numpy as np
from scipy.io import wavfile

sine = np.sin(2 * np.pi * 37.3 * np.arange(4000) / 4000)
wavfile.write("in.wav", 4000, np.column_stack([1e-6 * sine, 2e-8 * sine, 0.5 * sine]).astype("float32"))
END
cat >compare.py <<'END'
import numpy as np
from scipy.io import wavfile

before, after = (wavfile.read(name)[1] for name in ("in.wav", "out.wav"))
before = before[:after.shape[0]]
assert after.dtype == before.dtype == np.float32 and after.shape == (2000, 3)
assert np.max(np.abs(after[:, 2] - before[:, 2])) < 1e-7
print(np.unique(before[:, 0]).size, np.unique(after[:, 0]).size, np.count_nonzero(after[:, 1]))
END
python3 write.py || fail "SciPy does not write"
sox in.wav out.wav trim 0 2000s 2>sox.log || fail "sox: $(cat sox.log)"
[[ ! -s sox.log ]] || fail "there is a message: $(cat sox.log)"
read -r values left nanometres < <(python3 compare.py) ||
  fail "large samples are not copied, or not as floating-point numbers"
holds "$values > 1000 && $left < 50" "of $values values of 1e-6 there are $left left"
[[ "$nanometres" == 0 ]] || fail "of 2e-8 there are $nanometres samples left"
seen "of $values values of a sine of 1e-6 $left are left, of one of 2e-8 nothing but 0"
