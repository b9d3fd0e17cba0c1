# SPDX-License-Identifier: MIT
"""microslip.adaptors: joints in the programs of others."""

import os
import pickle
import sys

import numpy as np
import pytest

import microslip
from microslip.adaptors.scipy import solve_jointed
from microslip.adaptors.tmdsimpy import JointForce

IWAN = microslip.Joint.four_parameter(0.2, 0.25, -0.5, 0.1)


def central_differences(function, at, step):
    """Columns d function / d at_j."""
    columns = []
    for j in range(at.size):
        unit = np.zeros(at.size)
        unit[j] = step
        columns.append((function(at + unit) - function(at - unit)) / (2.0 * step))
    return np.stack(columns, axis=1)


# HarmonicForce


def test_harmonic_force_loses_what_the_joint_does():
    joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    amplitude = 7e-5
    found = microslip.HarmonicForce(3, 1024).evaluate(joint, [0, amplitude, 0, 0])
    # pi Im(f_1 conj(x_1)); 1024 samples leave some 1e-9.
    lost = np.pi * amplitude * found.force[1].imag
    assert lost == pytest.approx(joint.dissipation(amplitude), rel=1e-8)
    assert found.reversals == 2
    assert (found.lowest, found.highest) == pytest.approx((-amplitude, amplitude), rel=1e-12)


def test_harmonic_force_names_what_is_wrong():
    force = microslip.HarmonicForce(2)
    with pytest.raises(ValueError, match="displacement has 2 numbers; must have 3"):
        force.evaluate(IWAN, [0, 1])
    with pytest.raises(ValueError, match=r"displacement\[0\] = .*must be real"):
        force.evaluate(IWAN, [1j, 1, 0])
    with pytest.raises(ValueError, match="samples = 5.*must be from 6"):
        microslip.HarmonicForce(2, 5)
    copy = pickle.loads(pickle.dumps(microslip.HarmonicForce(2, 64)))
    assert (copy.harmonics, copy.samples) == (2, 64)


# tmdsimpy


@pytest.mark.parametrize("h", [[0, 1, 2, 3], [0, 1, 3, 5], [1, 3], [1, 2]], ids=str)
def test_derivatives_of_harmonics_are_those_of_differences(h):
    rng = np.random.default_rng(7)
    first, second = [[1.0, -1.0, 0.0]], [[0.0, 0.5, 1.0]]
    Q = np.array(first + second)
    force = JointForce(Q, Q.T, [IWAN, microslip.Joint(0.5, [microslip.Uniform(0, 0.8, 1)])])
    count = 2 * len(h) - (h[0] == 0)
    U = rng.normal(size=3 * count) / np.repeat(1.0 + np.arange(count), 3)
    found, jacobian, by_frequency = force.aft(U, 1.3, np.array(h), Nt=1024)
    # Differences: step**2 by the third derivative; what the samples leave, see HarmonicForce.
    differences = central_differences(lambda u: force.aft(u, 1.3, np.array(h), 1024)[0], U, 1e-5)
    np.testing.assert_allclose(jacobian, differences, atol=2e-6)
    assert not by_frequency.any()
    (alone,) = force.aft(U, 1.3, np.array(h), 1024, calc_grad=False)
    np.testing.assert_array_equal(alone, found)


def test_harmonics_are_those_of_a_loop():
    force = JointForce([[1.0]], [[1.0]], IWAN)
    U = np.array([0.0, 1.0, 0.3, 0.1, -0.2])
    samples = 4096
    angle = 2.0 * np.pi * np.arange(samples) / samples
    x = U[1] * np.cos(angle) + U[2] * np.sin(angle) + U[3] * np.cos(2 * angle) + U[4] * np.sin(2 * angle)
    loop = force.local_force_history(x[:, None])[0][:, 0]
    found = force.aft(U, 1.0, np.array([0, 1, 2]), Nt=512)[0]
    by_sums = [loop.mean(), *(2.0 * np.mean(loop * wave(n * angle))
                              for n in (1, 2) for wave in (np.cos, np.sin))]  # fmt: skip
    # The loop turns at samples: 2e-6 of the displacement, and less of the force.
    np.testing.assert_allclose(found, by_sums, atol=1e-6)


def test_static_force_has_the_memory_and_its_history():
    force = JointForce([[1.0, -1.0]], [[1.0], [-1.0]], IWAN)
    memory = IWAN.memory()
    for X in ([0.5, 0.0], [0.2, 0.3], [1.0, 0.2]):
        F, dFdX = force.force(X)
        u = X[0] - X[1]
        trial = memory.trial(u)
        np.testing.assert_allclose(F, [trial.force, -trial.force], rtol=1e-15)
        np.testing.assert_allclose(dFdX, trial.tangent * np.array([[1, -1], [-1, 1]]), rtol=1e-15)
        force.force(X, update_hist=True)
        memory.advance(u)
    force.init_history()
    assert force.force([0.1, 0.0])[0][0] == IWAN.force(0.1)


def test_prestress_without_friction_moves_where_joints_are_virgin():
    force = JointForce([[1.0]], [[1.0]], IWAN)
    force.set_prestress_mu()
    F, dFdX = force.force([2.0], update_hist=True)
    assert (F[0], dFdX[0, 0]) == (0.0, 0.0)
    assert not force.aft(np.array([2.0, 1.0, 0.0]), 1.0, np.array([0, 1]))[0].any()
    force.reset_real_mu()
    assert force.force([2.1])[0][0] == pytest.approx(IWAN.force(0.1), rel=1e-14)
    moved = force.aft(np.array([2.0, 1.0, 0.0]), 1.0, np.array([0, 1]))[0]
    fresh = JointForce([[1.0]], [[1.0]], IWAN).aft(np.array([0.0, 1.0, 0.0]), 1.0, np.array([0, 1]))[0]
    np.testing.assert_allclose(moved, fresh, atol=1e-15)


def test_tmdsimpy_force_names_what_is_wrong():
    with pytest.raises(ValueError, match=r"T has the shape \(1, 2\)"):
        JointForce([[1.0, 0.0]], [[1.0, 0.0]], IWAN)
    with pytest.raises(ValueError, match="joint has 2; must have 1"):
        JointForce([[1.0]], [[1.0]], [IWAN, IWAN])
    force = JointForce([[1.0]], [[1.0]], IWAN)
    with pytest.raises(ValueError, match="U has the shape"):
        force.aft(np.zeros(4), 1.0, np.array([0, 1]))
    with pytest.raises(ValueError, match="h = .*must be harmonics"):
        force.aft(np.zeros(3), 1.0, np.array([1, 0]))
    again = pickle.loads(pickle.dumps(force))
    assert again.joints == force.joints


@pytest.fixture
def tmdsimpy():
    """The folder of a clone, importable."""
    clone = os.environ.get("MICROSLIP_TMDSIMPY")
    if not clone:
        pytest.skip("MICROSLIP_TMDSIMPY does not name a clone of tmdsimpy")
    sys.path.insert(0, clone)
    try:
        yield pytest.importorskip("tmdsimpy.vibration_system")
    finally:
        sys.path.remove(clone)


def curve_by_tmdsimpy(system, force_vector, start, low, high, h, samples):
    """Rows (U, omega) of the resonance by the continuation of tmdsimpy."""
    from tmdsimpy.continuation import Continuation
    from tmdsimpy.solvers import NonlinearSolver
    from tmdsimpy.utils import harmonic

    first = np.append(start, low)
    dofs = system.M.shape[0]
    scale = harmonic.harmonic_wise_conditioning(first, dofs, h, delta=1e-3)
    scale[-1] = high
    config = {"DynamicCtoP": True, "verbose": -1, "corrector": "Ortho", "xtol": 1e-10 * first.size,
              "dsmin": 1e-4, "dsmax": 0.02, "MaxSteps": 2000}  # fmt: skip
    continuation = Continuation(NonlinearSolver(), ds0=0.01, CtoP=scale, config=config)
    return continuation.continuation(
        lambda Uw, calc_grad=True: system.hbm_res(Uw, force_vector, h, Nt=samples, calc_grad=calc_grad),
        first, low, high)  # fmt: skip


def test_harmonic_balance_of_tmdsimpy_has_the_resonance_of_ours(tmdsimpy):
    """Two masses with two joints, the first to the ground: every point of its curve lies on ours."""
    M, K = np.eye(2), np.array([[1.5, -0.75], [-0.75, 1.5]])
    C = 0.01 * K
    joints = [IWAN, microslip.Joint(0.2, [microslip.Uniform(0, 0.3, 1)])]
    Q = np.array([[1.0, 0.0], [-1.0, 1.0]])
    force, h, samples = 0.1, np.arange(6), 512

    square, shapes = np.linalg.eigh(K)
    omega = np.sqrt(square)
    structure = microslip.Structure(
        omega / (2 * np.pi), {"last": shapes[1]}, damping_ratio=0.005 * omega,
        joints=[microslip.StructuralJoint(j, q @ shapes) for j, q in zip(joints, Q)])  # fmt: skip
    balance = microslip.HarmonicBalance(structure, harmonics=5, samples=samples)

    system = tmdsimpy.VibrationSystem(M, K, C=C)
    system.add_nl_force(JointForce(Q, Q.T, joints))
    load = np.zeros(2 * 11)
    load[3] = force  # cosine of the first harmonic at the last mass
    low, high = 0.75, 1.1
    stuck = K + Q.T @ np.diag([j.stiffness for j in joints]) @ Q
    linear = np.linalg.solve(stuck - low**2 * M + 1j * low * C, load[2:4])
    start = np.zeros(22)
    start[2:4], start[4:6] = linear.real, -linear.imag
    curve = curve_by_tmdsimpy(system, load, start, low, high, h, samples)
    assert curve[-1, -1] >= high

    top = np.hypot(curve[:, 3], curve[:, 5])
    assert top.max() > 1.2 * max(top[0], top[-1])  # over a resonance, where joints slip
    for row, height in list(zip(curve, top))[1:-1:8]:
        ours = balance.solve(frequency=row[-1] / (2 * np.pi), force=force)
        # The same equations: what both leave of them, Newton's last step squared.
        assert ours.points.response[0] == pytest.approx(height, rel=1e-10)


# scipy


def free_structure(joints, shapes, mass, stiffness, damping):
    """The same in modes."""
    square, modes = np.linalg.eigh(stiffness / mass)
    omega = np.sqrt(square)
    modes = modes / np.sqrt(mass)
    structure = microslip.Structure(
        omega / (2 * np.pi), {"first": modes[0], "last": modes[-1]},
        damping_ratio=0.5 * damping * omega,
        joints=[microslip.StructuralJoint(j, q @ modes) for j, q in zip(joints, shapes)])  # fmt: skip
    return structure, modes


TWO_MASSES = {"mass": 2.0, "stiffness": 1e4 * np.array([[2.0, -1.0], [-1.0, 2.0]]), "damping": 1e-5}
TWO_JOINTS = [microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)]),
              microslip.Joint.four_parameter(4.0, 5e4, -0.5, 0.0)]  # fmt: skip
TWO_SHAPES = np.array([[1.0, 0.0], [-1.0, 1.0]])


def solved(force, end, start=None, **options):
    mass, K, damping = TWO_MASSES["mass"], TWO_MASSES["stiffness"], TWO_MASSES["damping"]
    return solve_jointed([mass, mass], damping * K, K, list(zip(TWO_JOINTS, TWO_SHAPES)), force,
                         (0.0, end), displacement=start, **options)  # fmt: skip


def test_free_vibration_is_that_of_march():
    structure, modes = free_structure(TWO_JOINTS, TWO_SHAPES, **TWO_MASSES)
    times = np.linspace(0.0, 0.2, 2001)
    start = np.array([-2e-4, 3e-4])
    found = solved(None, 0.2, start, t_eval=times, rtol=1e-11, atol=1e-16)
    marched = microslip.march(structure, times, step=1e-6, displacement=np.linalg.solve(modes, start))
    last = marched.points["last"].displacement
    # The tolerance of each of some hundred steps, 1e-11, adds up; march is better with this step.
    assert marched.error_estimate < 1e-12
    np.testing.assert_allclose(found.displacement[1], last, atol=1e-10 * abs(last).max())
    for path, motion in zip(found.joints, marched.joints.values()):
        np.testing.assert_allclose(path.force, motion.force, atol=2e-10 * abs(motion.force).max())
        assert len(path.reversals) > 5


def test_forced_vibration_is_that_of_march():
    structure, _ = free_structure(TWO_JOINTS, TWO_SHAPES, **TWO_MASSES)
    shape = lambda t: 5 * np.sin(2 * np.pi * 33 * t) + 3 * np.cos(2 * np.pi * 71 * t) - 3  # noqa: E731
    times = np.linspace(0.0, 0.3, 1001)
    found = solved(lambda t: [0.0, shape(t)], 0.3, t_eval=times, rtol=1e-10)
    errors = []
    for refined in (8, 16):
        fine = np.linspace(0.0, 0.3, 1000 * refined + 1)
        marched = microslip.march(structure, fine, {"last": shape(fine)}, every=refined)
        last = marched.points["last"].displacement
        errors.append(abs(found.displacement[1] - last).max() / abs(last).max())
    # march takes the force as linear between times: (omega dt)**2/12 of it, a quarter with half dt.
    assert errors[1] < 3e-5
    assert errors[0] / errors[1] == pytest.approx(4.0, rel=0.05)


def test_joints_that_turn_at_once_all_turn():
    """A symmetric structure in its symmetric motion: two joints as one of twice the stiffness."""
    K = np.array([[3e4, -1e4], [-1e4, 3e4]])
    joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    both = solve_jointed([2.0, 2.0], 1e-4 * K, K, [(joint, [1, 0]), (joint, [0, 1])],
                         lambda t: np.full(2, 8 * np.sin(200 * t)), (0, 0.2))  # fmt: skip
    one = solve_jointed([2.0], [2.0], [2e4], [(joint, [1])], lambda t: [8 * np.sin(200 * t)],
                        (0, 0.2), t_eval=both.time)  # fmt: skip
    for path in both.joints:
        assert len(path.reversals) == len(one.joints[0].reversals) > 5
    # Both solve to 1e-8 a step; the tolerances of either leave their sum.
    np.testing.assert_allclose(both.displacement[0], one.displacement[0],
                               atol=2e-6 * abs(one.displacement).max())  # fmt: skip
    np.testing.assert_allclose(both.displacement[0], both.displacement[1], atol=1e-14)


def test_rest_lasts_until_something_acts():
    pulse = lambda t: [0.0, -9.0 * np.sin(400 * (t - 0.02)) if t > 0.02 else 0.0]  # noqa: E731
    found = solved(pulse, 0.05, max_step=1e-4)
    resting = found.time < 0.0199  # steps of 1e-4: one may reach over the beginning of the pulse
    assert not found.displacement[:, resting].any()
    # The sense of the first motion is not known at rest: one turn may stand at its beginning.
    assert all(path.reversals[0] > 0.0199 for path in found.joints)
    assert abs(found.joints[0].force).max() > 1.0
    nothing = solved(None, 0.01)
    assert not nothing.displacement.any()
    assert all(len(path.reversals) == 0 for path in nothing.joints)


def test_scipy_helper_names_what_is_wrong():
    joint = TWO_JOINTS[0]
    good = {"mass": [1.0], "damping": [0.0], "stiffness": [1.0], "joints": [(joint, [1.0])],
            "force": None, "t_span": (0.0, 1.0)}  # fmt: skip
    for change, message in (
        ({"joints": [joint]}, r"joints\[0\] = .*must be a pair"),
        ({"joints": [(joint, [1.0, 2.0])]}, r"joints\[0\]: shape has 2 numbers; must have 1"),
        ({"stiffness": [1.0, 2.0]}, "stiffness has the shape"),
        ({"force": 3.0}, "force = 3.0; must be a function of time"),
        ({"force": lambda t: [1.0, 2.0]}, r"force\(0.0\) has 2 numbers"),
        ({"t_span": (1.0, 0.0)}, "t_span = .*must rise"),
        ({"mass": [0.0]}, "mass is singular"),
    ):
        with pytest.raises(ValueError, match=message):
            solve_jointed(**{**good, **change})
    with pytest.raises(ValueError, match="t_eval must rise, within"):
        solve_jointed(**good, t_eval=[0.0, 2.0])


def test_one_damping_serves_all_modes():
    shape = [1.0, 1.0]
    for damping in ({"loss_factor": 0.002}, {"damping_ratio": 0.001}):
        structure = microslip.Structure([10.0, 20.0], {"mass": shape}, **damping)
        assert structure.loss_factor.tolist() == [0.002, 0.002]


def test_bad_arguments_are_named(joint):
    for mass in ([-2.0], [0.0], [[1.0, 2.0], [2.0, 1.0]]):
        with pytest.raises(ValueError, match="^mass "):
            n = len(mass)
            solve_jointed(mass, [0.0] * n, [1e5] * n, [], None, (0.0, 0.1))
    for span in (5, (0.0, 1.0, 2.0), None, "ab", (0.0, np.nan), (1.0, 0.0)):
        with pytest.raises(ValueError, match="^t_span"):
            solve_jointed([2.0], [0.0], [1e5], [(joint, [1.0])], None, span)
    force = JointForce([[1.0]], [[1.0]], joint)
    for samples in (-1, 3, 64.0, None):
        with pytest.raises(ValueError, match="^Nt = "):
            force.aft(np.array([0.0, 1e-5, 0.0]), 1.0, np.array([0, 1]), Nt=samples)
    with pytest.raises(ValueError, match="^U"):
        force.aft(np.array([0.0, np.nan, 0.0]), 1.0, np.array([0, 1]))
