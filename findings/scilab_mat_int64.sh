#!/usr/bin/env bash
# Scilab 6.1.1 (scilab-cli 6.1.1+dfsg2-6), loadmatfile, and SciPy 1.10.1 (python3-scipy 1.10.1-2), savemat: whole
#   numbers, the directions -1, 2, -3 of three sensors.
#
# Guess: int64 with these numbers, as the file says and SciPy reads it; Scilab has that type.
# Instead: uint64, so that -1 is 18446744073709551615. Scilab's own savematfile writes int64, which SciPy reads as such,
#   and which Scilab reads back as uint64. In 32, 16 and 8 bits the signs stay. No message.
# Why it matters: NumPy gives whole numbers 64 bits unless it is told otherwise: polarities and directions of sensors,
#   delays in samples, node numbers. Positive ones are right, so that a table is trusted until the first negative one:
#   sign() of all three is 1, and a sensor that looks down is taken for one that looks up.
# A way to live with it: int64() of what was read, which brings the signs back; or astype(float) before savemat.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian scilab-cli=6.1.1+dfsg2-6 python3-scipy=1.10.1-2

cat >write.py <<'END'
import numpy as np
from scipy.io import savemat

directions = np.array([[-1, 2, -3]])
assert directions.dtype == np.int64
savemat("sensors.mat", {"whole": directions, "half": directions.astype("i4"), "quarter": directions.astype("i2"),
                        "eighth": directions.astype("i1"), "real": directions.astype(float)})
END
cat >read.py <<'END'
from scipy.io import loadmat

again = loadmat("again.mat")["again"]
print(again.dtype, *again.ravel())
END
cat >read.sce <<'END'
function show(name, numbers)
  mprintf("seen %s %s", name, typeof(numbers));
  for number = double(numbers)
    mprintf(" %.0f", number);
  end
  mprintf("\n");
endfunction
loadmatfile("sensors.mat");
show("whole", whole);
show("sign", sign(double(whole)));
show("back", int64(whole));
show("half", half);
show("quarter", quarter);
show("eighth", eighth);
show("real", real);
again = int64([-1 2 -3]);
savematfile("again.mat", "again", "-v7");
clear again;
loadmatfile("again.mat");
show("again", again);
exit
END
python3 write.py || fail "SciPy does not write whole numbers in 64 bits"
scilab read.sce >scilab.txt
(($(wc -l <scilab.txt) == 8)) || fail "Scilab does not run it: $(tail -n 3 scilab.log)"
! grep -q -i warning scilab.log || fail "there is a warning: $(grep -i warning scilab.log)"
large=18446744073709551616 # 2^64, which is what a double makes of 2^64 - 1 and of 2^64 - 3
for line in "whole uint64 $large 2 $large" "again uint64 $large 2 $large" "sign constant 1 1 1" "back int64 -1 2 -3" \
  "half int32 -1 2 -3" "quarter int16 -1 2 -3" "eighth int8 -1 2 -3" "real constant -1 2 -3"; do
  grep -qx "$line" scilab.txt || fail "$(grep "^${line%% *}" scilab.txt)"
done
found="$(python3 read.py)"
[[ "$found" == "int64 -1 2 -3" ]] || fail "SciPy reads what Scilab has written as $found"
seen "-1 2 -3 by SciPy are $(sed -n 's/^whole //p' scilab.txt), by Scilab itself $(sed -n 's/^again //p' scilab.txt)," \
  "which SciPy reads as $found"
