# SPDX-License-Identifier: MIT
# %% [markdown]
# # Thousands of joints on all cores
# Of a joint one knows the parameters to some percent. How far do the resonances spread? Calls of
# microslip run beside the interpreter's lock, so that threads do: no processes, nothing to pickle.

# %%
import os
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from pictures import BLUE, GREY, RED, pyplot, save

import microslip

COUNT = int(os.environ.get("MICROSLIP_MONTE_CARLO", "400"))  # 10000 take about half a minute on two cores
FORCE, FROM, TO = 5.0, 78.0, 104.0  # N, Hz
GRID = np.linspace(FROM, TO, 521)


def draw(number):
    """The joint of a number: the same in any order and on any thread."""
    rng = np.random.default_rng([20, number])
    return microslip.Joint.four_parameter(
        macroslip_force=200.0 * np.exp(0.3 * rng.normal()),
        stiffness=1e6 * np.exp(0.02 * rng.normal()),
        chi=np.clip(-0.5 + 0.1 * rng.normal(), -0.9, 0.0),
        beta=0.5,
    )


def structure(joint):
    """A mode of 60 Hz without the joint."""
    return microslip.Structure([60.0], {"point": [1.0]}, damping_ratio=0.003,
                               joints=[microslip.StructuralJoint(joint, [0.5])])  # fmt: skip


def response(number):
    """Frequency and height of the peak, and the curve over the grid."""
    curve = microslip.frequency_response(structure(draw(number)), FORCE, FROM, TO,
                                         harmonics=3, samples=128, accuracy=0.01)  # fmt: skip
    return curve.peaks.frequency[0], curve.peaks.response[0], np.interp(GRID, curve.frequency, curve.response)


# %%
began = time.perf_counter()
with ThreadPoolExecutor(os.cpu_count()) as pool:
    found = list(pool.map(response, range(COUNT)))
seconds = time.perf_counter() - began
frequency, height = (np.array([row[i] for row in found]) for i in (0, 1))
curves = np.array([row[2] for row in found])
print(f"{COUNT} frequency responses on {os.cpu_count()} cores: {seconds:.1f} s,"
      f" {1e3 * seconds / COUNT:.2f} ms each")  # fmt: skip
for name, values, scale, unit in (("frequency", frequency, 1, "Hz"), ("height", height, 1e6, "um")):
    low, middle, high = scale * np.quantile(values, [0.025, 0.5, 0.975])
    print(f"{name} of the peak: {middle:.2f} {unit}, 95 % from {low:.2f} to {high:.2f} {unit}")

# %%
figure, (left, right) = pyplot.subplots(1, 2, figsize=(10.4, 4.4), width_ratios=(1.3, 1))
for curve in curves[:60]:
    left.plot(GRID, 1e6 * curve, color=GREY, alpha=0.25, linewidth=0.7)
low, middle, high = 1e6 * np.quantile(curves, [0.025, 0.5, 0.975], axis=0)
left.fill_between(GRID, low, high, color=BLUE, alpha=0.2, linewidth=0, label=f"95 % of {COUNT}")
left.plot(GRID, middle, color=BLUE, label="median at a frequency")
left.plot([], [], color=GREY, linewidth=0.7, label="60 of them")
left.set(title=f"Responses to {FORCE:g} N", xlabel="frequency [Hz]", ylabel="displacement [µm]")
left.set_xlim(FROM, TO)
left.set_ylim(bottom=0.0)
left.legend(loc="upper right")
right.plot(frequency, 1e6 * height, ".", color=BLUE, markersize=5, alpha=max(0.15, min(0.6, 400 / COUNT)),
           markeredgewidth=0)  # fmt: skip
right.plot(np.median(frequency), 1e6 * np.median(height), "+", color=RED, markersize=12, mew=2,
           label="medians")  # fmt: skip
right.set(title="Their peaks", xlabel="frequency [Hz]", ylabel="displacement [µm]")
right.legend(loc="lower right")

# %%
save(figure, "monte_carlo.png")
