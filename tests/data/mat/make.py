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
