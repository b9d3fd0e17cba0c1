# SPDX-License-Identifier: MIT
"""Joints and their memory: closed forms, the program, values that are kept."""

import copy
import gc
import pickle

import numpy as np
import pytest

import microslip
from conftest import columns


def test_closed_forms_of_a_uniform_density():
    # phi = 1/q on [0, q]: F = kx - (kx)**2/(2q), D = (2/3) k**2 A**3/q, by hand from [AR14 (2) (7)].
    k, q = 1e5, 10.0
    joint = microslip.Joint(k, [microslip.Uniform(0, q, 1)])
    x = np.linspace(-9e-5, 9e-5, 7)
    force = k * x - np.sign(x) * (k * x) ** 2 / (2 * q)
    np.testing.assert_allclose(joint.force(x), force, rtol=1e-14)  # a few roundings
    amplitude = np.array([1e-6, 5e-5, 1e-4])
    loss = 2 / 3 * k**2 * amplitude**3 / q
    np.testing.assert_allclose(joint.dissipation(amplitude), loss, rtol=1e-13)
    assert joint.macroslip_force == pytest.approx(q / 2, rel=1e-15)
    assert joint.moments() == pytest.approx((1.0, q / 2, q**2 / 3), rel=1e-15)


def test_arrays_of_any_shape_dtype_and_layout(joint):
    x = np.linspace(-1e-4, 1e-4, 24).reshape(4, 6)
    forces = joint.force(x)
    assert forces.shape == x.shape
    for other in (np.asfortranarray(x), x[::-1][::-1], np.repeat(x, 2, axis=1)[:, ::2], x.tolist()):
        assert np.array_equal(joint.force(other), forces)
    single = joint.force(x.astype(np.float32))
    assert np.array_equal(single, joint.force(x.astype(np.float32).astype(float)))
    assert np.array_equal(joint.force(x.astype(">f8")), forces)
    assert np.array_equal(joint.force([0, 1]), joint.force([0.0, 1.0]))
    assert joint.force(np.float64(1e-5)) == joint.force(1e-5) == joint.force(np.array(1e-5))
    assert isinstance(joint.force(np.float32(1e-5)), float)
    assert joint.force(np.empty((0,)).reshape(1, 0) if False else [[1e-5]]).shape == (1, 1)


def test_same_bits_as_the_program(joint, program, tmp_path):
    rng = np.random.default_rng(5)
    path = np.cumsum(rng.normal(size=2000)) * 2e-6
    joint.write(tmp_path / "joint.json")
    (tmp_path / "path.csv").write_text(
        "displacement [m]\n" + "\n".join(repr(float(x)) for x in path) + "\n"
    )
    program("loop", "joint.json", "--path", "path.csv", "--out", "loop.csv")
    assert np.array_equal(columns(tmp_path / "loop.csv")["force"], joint.loop(path))
    program("dissipation", "joint.json", "--amplitude", "1e-6:1e-4:30:log", "--out", "d.csv")
    table = columns(tmp_path / "d.csv")
    assert np.array_equal(table["dissipation"], joint.dissipation(table["amplitude"]))
    assert np.array_equal(table["secant_stiffness"], joint.secant_stiffness(table["amplitude"]))
    assert np.array_equal(table["loss_factor"], joint.loss_factor(table["amplitude"]))


def test_files_keep_all_bits(joint, tmp_path):
    joint.write(tmp_path / "joint.json")
    assert microslip.Joint.read(tmp_path / "joint.json") == joint
    four = microslip.Joint.four_parameter(400.0, 2e7, -0.3, 0.7)
    four.write(str(tmp_path / "four.json"))
    assert microslip.Joint.read(tmp_path / "four.json") == four
    with pytest.raises(microslip.FileError, match="nothing.json"):
        microslip.Joint.read(tmp_path / "nothing.json")
    (tmp_path / "text.json").write_text("{")
    with pytest.raises(microslip.FormatError, match="text.json:1"):
        microslip.Joint.read(tmp_path / "text.json")
    with pytest.raises(OSError):
        joint.write(tmp_path / "no_folder" / "joint.json")


def test_trial_takes_no_step_and_advance_does(joint):
    memory = joint.memory()
    memory.advance(6e-5)
    before = (memory.displacement, memory.force, memory.reversals.tolist())
    response = memory.trial(-2e-5)
    assert (memory.displacement, memory.force, memory.reversals.tolist()) == before
    assert memory.advance(-2e-5) == response.force
    # The tangent by a central difference: the branch is smooth there, its error is that of h**2.
    h = 1e-9
    slope = (memory.copy().advance(-2e-5 - h) - response.force) / -h
    assert response.tangent == pytest.approx(slope, rel=1e-4)


def test_steps_are_the_path(joint):
    rng = np.random.default_rng(7)
    path = np.cumsum(rng.normal(size=500)) * 4e-6
    memory = joint.memory()
    assert np.array_equal([memory.advance(float(x)) for x in path], joint.loop(path))
    memory.reset()
    assert np.array_equal(memory.march(path), joint.loop(path))


def test_energy_of_a_step_balances(joint):
    # integral of f dx = what the sliders take + change of what the springs hold, along any path.
    memory = joint.memory()
    rng = np.random.default_rng(3)
    lost = work = 0.0
    for x in np.cumsum(rng.normal(size=40)) * 8e-6:
        # Fine enough that the trapezoidal rule is right to 1e-6 of the work.
        inner = np.linspace(memory.displacement, x, 400)
        start = memory.force
        lost += memory.dissipation(float(x))
        forces = np.concatenate([[start], memory.march(inner[1:])])
        work += float(np.sum(0.5 * (forces[1:] + forces[:-1]) * np.diff(inner)))
    assert work == pytest.approx(lost + memory.stored_energy(), rel=1e-5)


@pytest.mark.parametrize("keep", [copy.copy, copy.deepcopy, lambda m: pickle.loads(pickle.dumps(m))])
def test_copies_of_a_memory_go_their_own_way(joint, keep):
    rng = np.random.default_rng(11)
    path = np.cumsum(rng.normal(size=300)) * 5e-6
    ahead = np.cumsum(rng.normal(size=300)) * 5e-6
    memory = joint.memory()
    memory.march(path)
    kept = keep(memory)
    at = kept.force
    first = memory.march(ahead)
    assert kept.force == at != memory.force
    assert np.array_equal(kept.march(ahead), first)
    assert keep(joint.memory()).march(ahead).tolist() == joint.loop(ahead).tolist()


def test_joints_are_values(joint):
    again = pickle.loads(pickle.dumps(joint))
    assert again == joint and hash(again) == hash(joint) and again is not joint
    assert copy.deepcopy(joint) == joint
    assert joint != microslip.Joint(2.3e6, [])
    assert joint != "joint"
    assert len({joint, again}) == 1


def test_equal_parts_have_equal_hashes():
    for one, other in (
        (microslip.Atoms([1, 2], [1, 0]), microslip.Atoms((1.0, 2.0), np.array([1.0, -0.0]))),
        (microslip.Uniform(0, 10, 1), microslip.Uniform(0.0, np.float64(10), 1.0)),
    ):
        assert one == other and hash(one) == hash(other)
        assert len({microslip.Joint(1e5, [one]), microslip.Joint(1e5, [other])}) == 1
    assert microslip.Atoms([1, 2], [0.5, 0.5]) != microslip.Atoms([1, 2], [0.5, 0.4])


def test_objects_survive_their_parents():
    memory = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)]).memory()
    gc.collect()
    assert memory.advance(5e-5) == 3.75
    loop = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)]).loop([0.0, 5e-5])
    gc.collect()
    assert loop.tolist() == [0.0, 3.75]


def test_normal_load(joint, program, tmp_path):
    assert joint.with_normal_load(2.0).force(2e-5) == pytest.approx(2 * joint.force(1e-5), rel=1e-13)
    t = np.linspace(0, 1, 400)
    x, p = 5e-5 * np.sin(12 * t), 1 + 0.3 * np.cos(20 * t)
    joint.write(tmp_path / "joint.json")
    rows = "\n".join(f"{a!r},{b!r}" for a, b in zip(x.tolist(), p.tolist()))
    (tmp_path / "path.csv").write_text("displacement [m],normal_load [1]\n" + rows + "\n")
    for law in ("incremental", "total"):
        program("loop", "joint.json", "--path", "path.csv", "--normal-load-law", law, "--out", "l.csv")
        assert np.array_equal(columns(tmp_path / "l.csv")["force"], joint.loop(x, p, law=law))


def test_shows_itself(joint):
    assert "2.3e+06 N/m" in repr(joint) and "power_law" in repr(joint)
    assert joint._repr_html_().startswith("<table>")
    assert repr(joint.memory()) == "Memory(displacement=0.0, force=0.0, reversals=0)"


@pytest.mark.parametrize("name", ["force", "tangent_stiffness", "dissipation", "secant_stiffness",
                                  "loss_factor", "density_at"])  # fmt: skip
def test_numbers_of_any_kind_give_the_same(joint, name):
    function = getattr(joint, name)
    for number in (1, 1.0, np.float64(1.0), np.int64(1), np.float32(1.0), np.array(1.0)):
        found = function(number)
        assert type(found) is float and found == function(np.array([1.0]))[0]
    for bad in (True, np.nan, np.float64(np.inf), 10**400):
        with pytest.raises(ValueError):
            function(bad)
