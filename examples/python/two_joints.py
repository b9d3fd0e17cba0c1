# SPDX-License-Identifier: MIT
# %% [markdown]
# # Two joints in a structure of matrices
# A beam of finite elements that is clamped at one end by a joint and rests on another in its middle:
# matrices, modes, joints, resonances over the amplitude, and which joint loses what.

# %%
import numpy as np
from beam import beam_matrices
from pictures import BLUE, ORANGE, RED, pyplot, save

import microslip

# %%
ELEMENTS = 20
stiffness, mass = beam_matrices(ELEMENTS, length=0.8, bending=2.1e11 * 0.03 * 0.01**3 / 12,
                                mass_per_length=7850 * 0.03 * 0.01)  # fmt: skip

# %% [markdown]
# The deflection of the first node is fixed. Its slope is restrained by a joint to the ground, which slips as
# the clamp does; another joint holds the deflection of the middle.

# %%
clamp, middle, tip = 1, ELEMENTS, 2 * ELEMENTS
modes = microslip.modes(
    stiffness, mass, points={"tip": tip}, held=[0],
    joints={"clamp": (None, clamp, 4e3), "middle": (None, middle, 2e4)}, count=6, stuck=True,
)  # fmt: skip
print(modes)
structure = modes.structure(
    {
        "clamp": microslip.Joint.four_parameter(0.8, 4e3, -0.6, 0.5),  # N m over rad
        "middle": microslip.Joint.four_parameter(6.0, 2e4, -0.2, 0.0),
    },
    loss_factor=0.002,
)
print(f"\n{structure}")

# %% [markdown]
# Vibrations in phase resonance of the first mode, and responses to forces across it.

# %%
responses = np.geomspace(1e-6, 6e-4, 50)
backbone = microslip.backbone(structure, responses)
figure, axes = pyplot.subplots(1, 3, figsize=(13.2, 4.2))
figure.get_layout_engine().set(w_pad=0.12)
ax = axes[0]
for force in (1e-3, 1e-2, 5e-2):
    curve = microslip.frequency_response(structure, force, 13.0, 16.5)
    ax.semilogy(curve.frequency, curve.response, color=BLUE, linewidth=1.2)
    top = curve.peaks
    print(f"{force:g} N: {top.response[0]:.4g} m at {top.frequency[0]:.3f} Hz, damping ratio"
          f" {100 * top.damping_ratio[0]:.3f} %")  # fmt: skip
    ax.annotate(f"{1e3 * force:g} mN", (curve.frequency[-1], curve.response[-1]), (4, 0),
                textcoords="offset points", va="center", annotation_clip=False)  # fmt: skip
ax.semilogy(backbone.frequency, backbone.response, color=RED, linestyle="--", label="phase resonance")
ax.set(title="Responses of the tip", xlabel="frequency [Hz]", ylabel="displacement [m]")
ax.set_xlim(13.0, 16.5)
ax.set_ylim(bottom=1e-6)
ax.legend(loc="upper right")

ax = axes[1]
ax.semilogx(backbone.response, backbone.frequency, color=RED)
ax.set(title="Frequency and damping", xlabel="displacement of the tip [m]", ylabel="frequency [Hz]")
ax.yaxis.label.set_color(RED)
damping = ax.twinx()
damping.semilogx(backbone.response, 100 * backbone.points.damping_ratio, color=ORANGE)
damping.set_ylabel("damping ratio [%]", color=ORANGE)
damping.grid(False)

ax = axes[2]
shares = np.array([joint.dissipation for joint in backbone.points.joints]) / backbone.points.input_energy
names = [joint.name for joint in backbone.points.joints]
ax.stackplot(backbone.response, 100 * shares[0], 100 * shares[1], 100 * (1 - shares.sum(axis=0)),
             labels=[*names, "linear"], colors=[BLUE, ORANGE, "#cccccc"], alpha=0.85)  # fmt: skip
ax.set_xscale("log")
ax.set_xlim(backbone.response[0], backbone.response[-1])
ax.set_ylim(0, 100)
ax.set(title="Who takes the energy", xlabel="displacement of the tip [m]", ylabel="share of a cycle [%]")
ax.legend(loc="upper left", facecolor="white", frameon=True, framealpha=0.8)
for i in (0, 25, 49):
    print(f"at {backbone.response[i]:.3g} m: " + ", ".join(
        f"{name} {100 * share[i]:.1f} %" for name, share in zip(names, shares)))  # fmt: skip

# %%
save(figure, "two_joints.png")
