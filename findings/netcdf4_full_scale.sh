#!/usr/bin/env bash
# netCDF4 for Python 1.6.2 (python3-netcdf4 1.6.2-1+b1): a recording of 16-bit integers that touches full scale.
#
# Guess: samples are masked as missing where the variable has a _FillValue that says so; this one has none.
# Instead: -32767 is masked nevertheless: it is netCDF's fill value for variables without one; +32767 and -32768
#   are not. The largest absolute value, the mean and the sum of squares are those of the other samples, without a word.
# Why it matters: -32767 is negative full scale of converters that are made symmetric, and of
#   recordings that a program has scaled to 16 bits: the one value by which an overload is known. A record that clips on
#   its negative side only is judged to be clean; a filter gets samples that "masked" arrays hide.
# A way to live with it: Dataset.set_auto_mask(False); or h5py, which returns what is stored; or a _FillValue of -32768
#   when writing.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-netcdf4=1.6.2-1+b1 python3-h5py=3.7.0-8

cat >record.py <<'END'
import h5py
import netCDF4
import numpy as np

samples = np.clip(np.round(40000 * np.sin(2 * np.pi * np.arange(1000) / 50) - 15000), -32767, 32767).astype("int16")
with netCDF4.Dataset("record.nc", "w") as file:
    file.createDimension("time", samples.size)
    file.createVariable("acceleration", "i2", ("time",))[:] = samples
with netCDF4.Dataset("record.nc") as file:
    assert "_FillValue" not in file["acceleration"].ncattrs()
    masked = file["acceleration"][:]
    file.set_auto_mask(False)
    plain = file["acceleration"][:]
with h5py.File("record.nc") as file:
    assert np.array_equal(file["acceleration"][:], samples)
assert np.array_equal(plain, samples)
clipped = np.count_nonzero(samples == -32767)
print(f"{np.ma.count_masked(masked)} of {clipped} samples at -32767 are masked, the lowest is {masked.min()}")
assert np.ma.count_masked(masked) == clipped > 100 and masked.min() > -32767
END
python3 record.py >record.txt || fail "samples are read otherwise: $(cat record.txt)"
seen "$(cat record.txt)"
