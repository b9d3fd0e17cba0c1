# Made the .mat files of this folder, with SciPy 1.10.1: small variables of each kind plain and compressed.
import numpy as np
import scipy.io

channels = np.zeros((2,), dtype=[("name", "O"), ("unit", "O"), ("values", "O")])
channels[0] = ("force", "lbf", np.array([1.0, 2.0, 4.0]))
channels[1] = ("response", "mm/s^2", np.array([1.0 + 2.0j, -3.0, 0.5j]))
variables = {
    "fs": 512.0,
    "force": np.array([[0.5], [-1.25], [3e-300]]),
    "counts": np.array([[-3, 200, 7]], dtype=np.int16),
    "text": "größe",
    "rows": np.array(["ab", "c"]),
    "nested": {"fs": 256.0, "channels": channels, "cell": np.array(["x", 2.0], dtype=object)},
    "empty": np.zeros((0, 0)),
    "single": np.array([0.1, 0.2], dtype=np.float32),
}
scipy.io.savemat("plain5.mat", variables)
scipy.io.savemat("compressed5.mat", variables, do_compression=True)

# Functions as Simcenter Testlab exports them to MATLAB: 4 samples at 100 Hz from 2 s on.
def function(values, unit):
    x = {"start_value": 2000.0, "increment": 10.0, "number_of_values": 4.0, "quantity": {"label": "ms"}}
    y = {"values": np.array(values)[:, None], "quantity": {"label": unit}}
    return {"x_values": x, "y_values": y, "function_record": {"name": "Time"}}


scipy.io.savemat("testlab.mat", {"Force": function([1.0, 2.0, 3.0, 4.0], "kN"), "Tip": function([0.5, 0.25, 0.5, 1.0], "g")})

# A sweep in the only struct of a file, with the fields of a stepped sine, and a note beside it.
sweep = {"frequency": [80.0, 81.0], "force": [1.0, 1.0], "acceleration": [2.0, 3.0], "phase": [-1.0, -2.0]}
scipy.io.savemat("sweep.mat", {"Sweep": sweep, "note": "plate"})
scipy.io.savemat("two_sweeps.mat", {"Sweep": sweep, "Again": sweep})
