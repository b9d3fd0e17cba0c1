# SPDX-License-Identifier: MIT
# %% [markdown]
# # A beam with an elastic Coulomb slider, as one solves it with NLvib
# A cantilever of steel, 0.7 m by 30 mm by 30 mm, seven elements; an elastic dry friction element of
# 1.3e6 N/m that slips at 1 N, at 0.3 m; driven and seen at the tip. Dimensions and damping are those
# of an example for NLvib [Krack & Gross, Harmonic Balance for Nonlinear Vibration Problems, 2019] in
# github.com/pawsen/nlvib_examples. Its element is a joint of one atom.

# %%
import warnings

import numpy as np
from beam import beam_matrices
from pictures import BLUE, GREY, RED, pyplot, save
from scipy.linalg import eigh

import microslip

LENGTH, SIDE, YOUNG, DENSITY = 0.7, 0.03, 185e9, 7830.0
SLIDER, TIP = 6, 14  # rows of deflections: of the fourth node and of the eighth
STIFFNESS, LIMIT = 1.3e6, 1.0  # N/m, N
FORCES = (0.05, 0.1, 0.2, 0.3, 0.6)  # N


def matrices():
    """Stiffness and mass; rows 0 and 1 are clamped."""
    return beam_matrices(7, LENGTH, YOUNG * SIDE**4 / 12, DENSITY * SIDE**2)


def damping_law(first, second):
    """alpha and beta of alpha M + beta K with 0.8 % and 0.2 % at two angular frequencies."""
    beta = 2 * (0.002 * second - 0.008 * first) / (second**2 - first**2)
    return 2 * first * 0.008 - beta * first**2, beta


def structure():
    """All modes of the stuck beam, which proportional damping leaves apart."""
    slider = {"slider": (None, SLIDER, STIFFNESS)}
    found = microslip.modes(*matrices(), points={"tip": TIP}, held=[0, 1], joints=slider, count=14,
                            stuck=True, attachment=False)  # fmt: skip
    omega = 2 * np.pi * found.frequency
    alpha, beta = damping_law(*omega[:2])
    jenkins = microslip.Joint(STIFFNESS, [microslip.Atoms([LIMIT], [1.0])])
    return found.structure({"slider": jenkins}, damping_ratio=(alpha / omega + beta * omega) / 2)


def resonance(force):
    balance = microslip.HarmonicBalance(structure(), harmonics=7, samples=1024)
    with warnings.catch_warnings():
        # 7 harmonics, as in the example that this follows: those above change it by some 0.3 %.
        warnings.filterwarnings("ignore", "truncat", microslip.MicroslipWarning)
        return balance.frequency_response(force, 38.0, 75.0)


def main():
    figure, ax = pyplot.subplots(figsize=(7.2, 4.6))
    for force in FORCES:
        curve = resonance(force)
        rms = np.sqrt((np.abs(curve.displacement("tip")[:, 1:]) ** 2).sum(axis=1) / 2)
        ax.semilogy(curve.frequency, 1e6 * rms / force, color=BLUE, linewidth=1.3)
        top = int(np.argmax(rms))
        ax.plot(curve.frequency[top], 1e6 * rms[top] / force, "o", color=RED, markersize=4)
        ax.annotate(f"{force:g} N", (curve.frequency[top], 1e6 * rms[top] / force), (0, 5),
                    textcoords="offset points", ha="center", fontsize=9)  # fmt: skip
        print(f"{force:g} N: largest {1e6 * rms[top]:.4f} um RMS at {curve.frequency[top]:.4f} Hz")
    stiffness, mass = (matrix.toarray()[2:, 2:] for matrix in matrices())
    free = np.sqrt(eigh(stiffness, mass, eigvals_only=True)[0]) / (2 * np.pi)
    stuck = structure().stuck_frequencies()[0]
    for at, name in ((free, "slipping"), (stuck, "stuck")):
        ax.axvline(at, color=GREY, linestyle=":", linewidth=1)
        ax.annotate(name, (at, 0.02), (3, 0), xycoords=("data", "axes fraction"),
                    textcoords="offset points", color=GREY, fontsize=9)  # fmt: skip
    print(f"first frequency: {free:.4f} Hz slipping, {stuck:.4f} Hz stuck")
    ax.set(title="Cantilever with an elastic dry friction element", xlabel="frequency [Hz]",
           ylabel="tip displacement over force, RMS [µm/N]")  # fmt: skip
    save(figure, "friction_beam.png")


# %%
if __name__ == "__main__":
    main()
