#!/usr/bin/env bash
# h5diff of HDF5 1.10.8 (hdf5-tools 1.10.8+repack1-1) and a result that ends early.
#
# Guess: a data set of 4 numbers and one with the first 3 of them differ: exit status 1, as for a number that differs.
# Instead: "Some objects are not comparable", and exit status 0, which stands for "no differences found". So it is with
#   a limit (-d), and where a number that both have differs.
# Why it matters: h5diff is how results in HDF5 are held against those of an earlier version. A march that breaks
#   off, or lost a channel, passes in a script that asks the exit status.
# A way to live with it: h5diff -c, and fail where it prints anything; or compare the shapes first (h5ls).
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian hdf5-tools=1.10.8+repack1-1 python3-h5py=3.7.0-8

cat >write.py <<'END'
import h5py

results = {"whole": [1.0, 2, 3, 4], "early": [1.0, 2, 3], "other": [1.0, 2, 3, 5], "both": [7.0, 2, 3]}
for name, numbers in results.items():
    with h5py.File(f"{name}.h5", "w") as file:
        file["displacement"] = numbers
END
python3 write.py || fail "h5py does not write"

status_of() {
  local status=0
  h5diff "$@" >diff.log 2>&1 || status=$?
  echo "$status"
}
[[ "$(status_of whole.h5 whole.h5) $(status_of whole.h5 other.h5)" == "0 1" ]] ||
  fail "the status of plain differences is another"
early="$(status_of whole.h5 early.h5)"
limit="$(status_of -d 1e-9 whole.h5 early.h5)"
both="$(status_of whole.h5 both.h5)"
[[ "$early $limit $both" == "0 0 0" ]] ||
  fail "a shorter data set has the status $early, with a limit $limit, with other numbers $both"
grep -q "not comparable" diff.log || fail "the message is another: $(cat diff.log)"
[[ -n "$(h5diff -c whole.h5 early.h5)" ]] || fail "h5diff -c prints nothing"
seen "exit status 1 for a number that differs, 0 for a data set that is shorter"
