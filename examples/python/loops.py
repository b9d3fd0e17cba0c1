# SPDX-License-Identifier: MIT
# %% [markdown]
# # Loops of a joint
# Its memory, what it dissipates, and what a normal load that varies does to it.

# %%
import numpy as np
from pictures import BLUE, GREEN, GREY, RED, pyplot, save

import microslip

joint = microslip.Joint.four_parameter(macroslip_force=400.0, stiffness=2.5e5, chi=-0.5, beta=1.0)
print(joint)
figure, axes = pyplot.subplots(2, 2, figsize=(9.6, 7.2))


def there_and_back(amplitude, cycles=1, points=400):
    """From 0 up, then `cycles` times down and up."""
    turns = [0.0, amplitude] + cycles * [-amplitude, amplitude]
    return np.concatenate([np.linspace(a, b, points) for a, b in zip(turns, turns[1:])])


# %% [markdown]
# Loops of rising amplitude hang on the virgin curve, which each leaves where it turns.

# %%
ax = axes[0, 0]
for amplitude, shade in zip((4e-3, 3e-3, 2e-3, 1e-3), (0.4, 0.6, 0.8, 1.0)):
    path = there_and_back(amplitude)
    ax.plot(1e3 * path[400:], joint.loop(path)[400:], color=BLUE, alpha=shade)
virgin = np.linspace(0.0, 4e-3, 300)
ax.plot(1e3 * virgin, joint.force(virgin), color=RED, linestyle="--", label="virgin curve")
ax.set(title="Loops hang on the virgin curve", xlabel="displacement [mm]", ylabel="force [N]")
ax.legend(loc="upper left")

# %% [markdown]
# Inside of a loop it remembers each reversal until the path passes it: then all inside is forgotten.

# %%
ax = axes[0, 1]
turns = np.array([0.0, 3.2, -2.6, 2.0, -1.4, 0.6, 3.2, 4.0]) * 1e-3
memory = joint.memory()
print("\nreversals that are remembered:")
for start, end in zip(turns, turns[1:]):
    path = np.linspace(start, end, 200)
    ax.plot(1e3 * path, memory.march(path), color=GREEN if end == turns[-1] else BLUE)
    print(f"  at {1e3 * end:5.1f} mm: {len(memory.reversals)}")
ax.plot(1e3 * virgin, joint.force(virgin), color=RED, linestyle="--")
ax.annotate("all forgotten:\nthe virgin curve goes on", (3.3, joint.force(3.3e-3)), (0.2, -370),
            arrowprops={"arrowstyle": "->", "color": GREY}, fontsize=9)  # fmt: skip
ax.set(title="Inner loops close, and are forgotten", xlabel="displacement [mm]", ylabel="force [N]")

# %% [markdown]
# The area of a loop is D(A). At small amplitude a four-parameter joint loses A to the power of 3 + chi.

# %%
ax = axes[1, 0]
amplitude = np.geomspace(1e-6, 1e-2, 200)
lost = joint.dissipation(amplitude)
ax.loglog(1e3 * amplitude, lost, color=BLUE)
ends = [0, 80]
slope = np.diff(np.log(lost[ends]))[0] / np.diff(np.log(amplitude[ends]))[0]
ax.loglog(1e3 * amplitude[:110], lost[40] * (amplitude[:110] / amplitude[40]) ** 2.5 * 2.5,
          color=GREY, linestyle=":", label="slope 3 + $\\chi$ = 2.5")  # fmt: skip
ax.axvline(1e3 * joint.macroslip_displacement, color=RED, linestyle="--", label="macro-slip")
path = there_and_back(1e-3, points=4000)
force = joint.loop(path)
area = np.trapz(force[4000:], path[4000:])
print(f"\nslope of ln D at small amplitude: {slope:.4f}")
print(f"area of the loop of 1 mm: {area:.6g} J; D(1 mm) = {joint.dissipation(1e-3):.6g} J")
ax.set(title="Dissipation per cycle", xlabel="amplitude [mm]", ylabel="dissipation [J]")
ax.legend()

# %% [markdown]
# A normal load that varies with twice the frequency of the motion moves what slips along the loop.

# %%
ax = axes[1, 1]
phase = np.linspace(0.0, 6.0 * np.pi, 3001)
path = 2.5e-3 * np.sin(phase)
last = phase >= 4.0 * np.pi
for share, colour, label in ((0.0, GREY, "constant load"), (0.3, BLUE, "1 + 0.3 cos 2$\\omega t$")):
    load = 1.0 + share * np.cos(2.0 * phase)
    force = joint.loop(path, load, elements=500)
    ax.plot(1e3 * path[last], force[last], color=colour, label=label)
    print(f"load varies by {share:g}: {np.trapz(force[last], path[last]):.4f} J a cycle")
ax.set(title="A normal load that varies", xlabel="displacement [mm]", ylabel="force [N]")
ax.legend(loc="upper left")

# %%
save(figure, "loops.png")
