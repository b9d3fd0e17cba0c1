# SPDX-License-Identifier: MIT
# %% [markdown]
# # A superharmonic resonance, as one solves it with tmdsimpy
# A mass on a spring, with an Iwan joint of four parameters beside it, driven with a third of its
# resonance: the third harmonic of the joint force finds it. The numbers are those of the example
# `sdof_iwan_hysteresis.py` of github.com/tmd-lab/tmdsimpy, where 100 sliders stand for the joint.

# %%
import warnings

import numpy as np
from pictures import BLUE, GREY, RED, pyplot, save

import microslip

MASS, DAMPING, SPRING = 1.0, 0.01, 0.75  # kg, N s/m, N/m
JOINT = microslip.Joint.four_parameter(macroslip_force=0.2, stiffness=0.25, chi=-0.5, beta=0.0)
FORCES = (3.3, 38.0)  # N
FROM, TO = 0.2, 0.4  # rad/s


def structure():
    omega = np.sqrt(SPRING / MASS)
    shape = [MASS**-0.5]
    return microslip.Structure(
        [omega / (2 * np.pi)],
        {"mass": shape},
        damping_ratio=DAMPING / (2 * MASS * omega),
        joints=[microslip.StructuralJoint(JOINT, shape)],
    )


def third_harmonics(force, harmonics=3):
    """Angular frequencies, rad/s, and amplitudes of the harmonics, m; fine about the resonance."""
    fine = np.linspace(0.28, 0.33, 401) / (2 * np.pi)
    balance = microslip.HarmonicBalance(structure(), harmonics=harmonics, samples=1024, frequencies=fine)
    with warnings.catch_warnings():
        # Harmonics 1 and 3 alone, as in the example that this follows; and below the resonance.
        warnings.filterwarnings("ignore", "truncated|no_resonance", microslip.MicroslipWarning)
        curve = balance.frequency_response(force, FROM / (2 * np.pi), TO / (2 * np.pi))
    return 2 * np.pi * curve.frequency, np.abs(curve.displacement("mass"))


def main():
    figure, axes = pyplot.subplots(1, 2, figsize=(10.0, 4.2))
    for ax, force in zip(axes, FORCES):
        omega, amplitude = third_harmonics(force)
        top = int(np.argmax(amplitude[:, 3]))
        print(f"{force:g} N: third harmonic up to {amplitude[top, 3]:.6f} m at {omega[top]:.4f} rad/s,"
              f" where the first has {amplitude[top, 1]:.4f} m")  # fmt: skip
        ax.plot(omega, amplitude[:, 1] / force, color=BLUE, linestyle="--", label="harmonic 1")
        ax.plot(omega, amplitude[:, 3] / force, color=RED, label="harmonic 3")
        ax.plot(omega[top], amplitude[top, 3] / force, "o", color=RED, markersize=4)
        ax.axhline(0.0, color=GREY, linewidth=0.6)
        ax.set(title=f"{force:g} N", xlabel="frequency of the force [rad/s]",
               ylabel="displacement over force [m/N]", xlim=(0.25, 0.35))  # fmt: skip
        ax.legend(loc="center left")
    save(figure, "superharmonic_iwan.png")


# %%
if __name__ == "__main__":
    main()
