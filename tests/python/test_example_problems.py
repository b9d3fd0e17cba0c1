# SPDX-License-Identifier: MIT
"""The problems of examples/python that others solve too, against harmonic balance of this file alone:
single sliders, one sample after the other, condensed to the displacement of the joint."""

import importlib
import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize_scalar, root

EXAMPLES = Path(__file__).parents[2] / "examples" / "python"


@pytest.fixture
def example(monkeypatch):
    """Imports one."""
    pytest.importorskip("matplotlib")
    monkeypatch.syspath_prepend(str(EXAMPLES))
    yield importlib.import_module
    for name in ("pictures", "beam", "friction_beam", "superharmonic_iwan"):
        sys.modules.pop(name, None)


class Sliders:
    """Springs k_i with sliders of limits f_i side by side; odd harmonics of the force by sums."""

    def __init__(self, springs, limits, orders, samples):
        self.springs, self.limits = np.asarray(springs, float), np.asarray(limits, float)
        angle = 2.0 * np.pi * np.arange(samples) / samples
        self.waves = np.exp(1j * np.outer(orders, angle))  # (orders, samples)

    def harmonics(self, displacement):
        """Of the steady cycle: from half a cycle on, as it is half-wave symmetric, and once round."""
        u = np.real(displacement @ self.waves)
        path = np.concatenate((u[len(u) // 2 :], u)).tolist()
        forces = self.of_one(path) if len(self.springs) == 1 else self.of_many(path)
        return 2.0 / len(u) * (self.waves.conj() @ forces[-len(u) :])

    def of_many(self, path):
        forces = []
        relaxed_at = np.zeros_like(self.springs)
        for at in path:
            each = np.minimum(np.maximum(self.springs * (at - relaxed_at), -self.limits), self.limits)
            relaxed_at = at - each / self.springs
            forces.append(each.sum())
        return np.array(forces)

    def of_one(self, path):
        forces = []
        spring, limit, relaxed_at = float(self.springs[0]), float(self.limits[0]), 0.0
        for at in path:
            force = min(max(spring * (at - relaxed_at), -limit), limit)
            relaxed_at = at - force / spring
            forces.append(force)
        return np.array(forces)


def balanced(compliance, driven, sliders, force, guess):
    """Harmonics u of the joint with u = force*driven - compliance*f(u), each of its orders."""

    def residual(numbers):
        u = numbers.view(complex)
        rest = u - force * driven + compliance * sliders.harmonics(u)
        return (rest / abs(driven[0]) / force).view(float)

    found = root(residual, guess.view(float), tol=1e-9)
    assert found.success, found.message
    return found.x.view(complex)


def largest(height, at, width):
    """Where `height` is largest, within `width` of a first look, and how large."""
    grid = at + np.linspace(-width, width, 13)
    tops = [height(x) for x in grid]
    top = int(np.argmax(tops))
    assert 0 < top < len(grid) - 1
    found = minimize_scalar(lambda x: -height(x), bounds=(grid[top - 1], grid[top + 1]),
                            method="bounded", options={"xatol": 1e-6 * at})  # fmt: skip
    return found.x, -found.fun


@pytest.mark.parametrize("force", [0.1, 0.3])
def test_peak_of_the_beam_with_an_elastic_slider(example, force, monkeypatch):
    beam = example("friction_beam")
    stiffness, mass = (matrix.toarray()[2:, 2:] for matrix in beam.matrices())
    joint, tip = beam.SLIDER - 2, beam.TIP - 2
    stuck = stiffness.copy()
    stuck[joint, joint] += beam.STIFFNESS
    first, second = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(mass, stuck)).real)[:2])
    alpha, beta = beam.damping_law(first, second)
    damping = alpha * mass + beta * stuck
    orders = np.array([1, 3, 5, 7])
    sliders = Sliders([beam.STIFFNESS], [beam.LIMIT], orders, 1024)
    latest = np.zeros(4, complex)

    def root_mean_square(hertz):
        omega = 2.0 * np.pi * hertz
        inverses = [np.linalg.inv(stiffness - (n * omega) ** 2 * mass + 1j * n * omega * damping)
                    for n in orders]  # fmt: skip
        compliance = np.array([inverse[joint, joint] for inverse in inverses])
        driven = np.array([inverses[0][joint, tip], 0, 0, 0])
        guess = latest if latest.any() else force * driven / (1 + beam.STIFFNESS * compliance)
        latest[:] = balanced(compliance, driven, sliders, force, guess.copy())
        of_joint = sliders.harmonics(latest)
        at_tip = [-inverse[tip, joint] * f for inverse, f in zip(inverses, of_joint)]
        at_tip[0] += force * inverses[0][tip, tip]
        return np.sqrt(np.square(np.abs(at_tip)).sum() / 2.0)

    curve = beam.resonance(force)
    ours = np.sqrt((np.abs(curve.displacement("tip")[:, 1:]) ** 2).sum(axis=1) / 2.0)
    at = curve.frequency[int(np.argmax(ours))]
    frequency, height = largest(root_mean_square, at + 0.03, 0.5)
    # A slider that turns between two of 1024 samples: (pi/1024)**2/2 of its displacement, 5e-6, which
    # a slider that hardly slips makes ten times as large. A flat top: its frequency to the root.
    assert ours.max() == pytest.approx(height, rel=1e-4)
    assert at == pytest.approx(frequency, rel=2e-3)


@pytest.mark.parametrize("force", [3.3, 38.0])
def test_peak_of_the_superharmonic_resonance_of_an_iwan_joint(example, force):
    iwan = example("superharmonic_iwan")
    limit, k, chi = 0.2, 0.25, -0.5  # of its joint, beta 0
    longest = limit / k * (chi + 2.0) / (chi + 1.0)  # m, where the last slider slips [Segalman 2005]
    coefficient = limit * (chi + 2.0) / longest ** (chi + 2.0)  # of rho(x) = R x**chi, N/m per m
    edges = longest * np.linspace(0.0, 1.0, 301) ** 2
    springs = coefficient / (chi + 1.0) * np.diff(edges ** (chi + 1.0))
    limits = coefficient / (chi + 2.0) * np.diff(edges ** (chi + 2.0))  # exact shares of both
    assert springs.sum() == pytest.approx(k, rel=1e-12)
    assert limits.sum() == pytest.approx(limit, rel=1e-12)
    orders = np.array([1, 3])
    sliders = Sliders(springs, limits, orders, 512)
    latest = np.zeros(2, complex)

    def third(omega):
        compliance = 1.0 / (iwan.SPRING - (orders * omega) ** 2 * iwan.MASS
                            + 1j * orders * omega * iwan.DAMPING)  # fmt: skip
        driven = np.array([compliance[0], 0.0])
        guess = latest if latest.any() else force * driven
        latest[:] = balanced(compliance, driven, sliders, force, guess.copy())
        return abs(latest[1])

    omega, amplitude = iwan.third_harmonics(force)
    top = int(np.argmax(amplitude[:, 3]))
    frequency, height = largest(third, omega[top] + 1e-4, 0.003)
    # 300 sliders of exact shares: some 1e-5; 512 samples: (pi/512)**2/2, 2e-5, of what is 1/5 of the
    # first harmonic or less; the grid of the example, 1e-4 rad/s on a top of 3e-3 width.
    assert amplitude[top, 3] == pytest.approx(height, rel=1e-3)
    assert omega[top] == pytest.approx(frequency, abs=1.5e-4)
