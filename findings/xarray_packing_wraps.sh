#!/usr/bin/env bash
# xarray 2023.01.0 (python3-xarray 2023.01.0-1.1) and netCDF4 for Python 1.6.2 (python3-netcdf4 1.6.2-1+b1) write
# accelerations packed to 16 bits with a scale_factor of 0.001 m/s^2, one of which is 33 m/s^2.
#
# Guess: 32.767, the largest that fits; or a missing value; or an error, as the netCDF library itself has one for
#   numbers out of range, NC_ERANGE.
# Instead: -32.536 m/s^2. The quotient is rounded and its lowest 16 bits are kept, by both programs, each of which does
#   this before the library sees the numbers. No message, also where warnings of NumPy are errors.
# Why it matters: scale factors are chosen for the range of the sensor, and an impact or a separating joint exceeds it.
#   A clipped peak is looked for and seen; one that is folded to the other side looks like chatter of the contact.
# A way to live with it: numpy.clip to +-32766 steps before writing, and count what is clipped; or 32-bit numbers.
. "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/lib.sh"
debian python3-xarray=2023.01.0-1.1 python3-netcdf4=1.6.2-1+b1

cat >pack.py <<'END'
import warnings

import netCDF4
import numpy as np
import xarray as xr

acceleration = np.array([1.0, 32.767, 33.0, 40.0, -33.0])
warnings.filterwarnings("error", category=RuntimeWarning, message=".*(cast|overflow|range)")
encoding = {"acceleration": {"dtype": "int16", "scale_factor": 0.001, "_FillValue": -32768}}
xr.Dataset({"acceleration": ("time", acceleration)}).to_netcdf("xarray.nc", encoding=encoding)
with netCDF4.Dataset("netcdf4.nc", "w") as file:
    file.createDimension("time", acceleration.size)
    variable = file.createVariable("acceleration", "i2", ("time",), fill_value=-32768)
    variable.scale_factor = 0.001
    variable[:] = acceleration
results = []
for name in ("xarray.nc", "netcdf4.nc"):
    with netCDF4.Dataset(name) as file:
        file.set_auto_maskandscale(False)
        results.append(file["acceleration"][:] * 0.001)
print("of", *acceleration, "xarray makes", *np.round(results[0], 3), "and netCDF4", *np.round(results[1], 3))
for result in results:
    assert np.allclose(result, [1, 32.767, -32.536, -25.536, 32.536], atol=1e-9)
END
python3 pack.py >pack.txt 2>pack.log || fail "packing is otherwise: $(cat pack.txt; tail -n 1 pack.log)"
seen "$(cat pack.txt)"
