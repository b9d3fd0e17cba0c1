# SPDX-License-Identifier: MIT
# %% [markdown]
# # From levels to a frequency response, with a band
# Eight levels of a real bolted lap joint, the Brake-Reuss beam; what they leave possible of its
# joint; and what that means for the response to forces.

# %%
import warnings
from pathlib import Path

import numpy as np
from pictures import BLUE, RED, pyplot, save

import microslip

warnings.simplefilter("ignore", microslip.MicroslipWarning)  # they are printed with the result

here = Path(__file__).parent if "__file__" in globals() else Path.cwd()
levels = microslip.Levels.read(here.parent / "brake_reuss_beam" / "levels.csv")
print(levels)

# %% [markdown]
# The stiffness of the mode at the drive point scales the slip forces. Draws are joints that the levels
# leave possible, each as likely as any other.

# %%
found = microslip.identify(levels, stiffness=5.08e5, linear_damping=True, samples=1000, seed=1)
print(f"\n{found}")

# %% [markdown]
# The mode is a mass on this joint alone.

# %%
MASS = 1.99  # kg
shape = [MASS**-0.5]


def beam(joint, linear_damping):
    return microslip.Structure(
        [0.0],
        {"drive point": shape},
        joints=[microslip.StructuralJoint(joint, shape, linear_damping=linear_damping)],
    )


# %% [markdown]
# One frequency response a draw, at the frequencies of a grid; the band holds 95 % of them. Its height
# is sharp, as dissipation was measured. Its frequency is not: what may slip below the lowest level
# costs stiffness and hardly any energy, and the measured one even rises, as the warning reports.

# %%
draws = [beam(joint, beta) for joint, beta in zip(found.draws[:60], found.draws.linear_damping)]
force_at = levels.dissipation / (np.pi * levels.amplitude)  # N, at phase resonance
grid = np.linspace(79.0, 81.2, 331)


def response(structure, force):
    curve = microslip.frequency_response(structure, force, grid[0], grid[-1], harmonics=1,
                                         samples=128, accuracy=0.005)  # fmt: skip
    return np.interp(grid, curve.frequency, curve.response)


figure, (left, right) = pyplot.subplots(1, 2, figsize=(10.4, 4.4), width_ratios=(1, 1.25))
found.plot(left, color=BLUE)
left.set_title("Density of the joint from the levels")
print()
for i in (3, 5, 7):
    drawn = 1e6 * np.array([response(structure, force_at[i]) for structure in draws])
    low, middle, high = np.quantile(drawn, [0.025, 0.5, 0.975], axis=0)
    right.fill_between(grid, low, high, color=BLUE, alpha=0.25, linewidth=0)
    right.plot(grid, middle, color=BLUE)
    right.plot(levels.frequency[i], 1e6 * levels.amplitude[i], "o", color=RED)
    right.annotate(f"{force_at[i]:.2f} N", (grid[-1], middle[-1]), (4, 0), textcoords="offset points",
                   va="center", annotation_clip=False)  # fmt: skip
    tops, where = np.quantile(drawn.max(axis=1), [0.025, 0.975]), grid[drawn.argmax(axis=1)]
    print(f"{force_at[i]:.3f} N: 95 % of the peaks from {tops[0]:.1f} to {tops[1]:.1f} um and from"
          f" {np.quantile(where, 0.025):.2f} to {np.quantile(where, 0.975):.2f} Hz; measured"
          f" {1e6 * levels.amplitude[i]:.1f} um at {levels.frequency[i]:.2f} Hz")  # fmt: skip
right.plot([], [], color=BLUE, label="median and 95 % of the draws")
right.plot([], [], "o", color=RED, label="measured at phase resonance")
right.set(title="Response of the drive point", xlabel="frequency [Hz]", ylabel="displacement [µm]")
right.set_xlim(grid[0], grid[-1])
right.set_ylim(0.0, 400.0)
right.legend(loc="upper right")

# %%
save(figure, "levels_to_frf.png")
