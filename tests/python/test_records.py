# SPDX-License-Identifier: MIT
"""Joints of force-displacement records: the same as the program finds them."""

import json
import os
import pickle
import subprocess

import numpy as np
import pytest

import microslip

# What must be known of small tests is no error here.
pytestmark = pytest.mark.filterwarnings("ignore::microslip.MicroslipWarning")
PROGRAM = os.environ.get("MICROSLIP_PROGRAM")
needs_program = pytest.mark.skipif(PROGRAM is None, reason="MICROSLIP_PROGRAM is not set")
DATA = os.path.join(os.path.dirname(__file__), "../data/force_records")


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True, capture_output=True)


def truth():
    return microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])


def arrays():
    t = np.arange(3000) / 1000
    u = 8e-5 * np.sin(2 * np.pi * 2 * t) * t / 3
    noise = 0.01 * np.random.default_rng(2).standard_normal(len(t))
    return microslip.Memory(truth()).march(u) + noise, u


@pytest.fixture(scope="module")
def found():
    force, u = arrays()
    return microslip.identify_records(force=force, displacement=u, fs=1000, samples=100, seed=4)


def same_density(joint, other):
    assert joint.stiffness == other.stiffness
    (mine,), (others,) = joint.density, other.density
    np.testing.assert_array_equal(mine.slip_force, others.slip_force)
    np.testing.assert_array_equal(mine.density, others.density)


def same_json(path, other):
    """All but where it comes from."""
    mine, theirs = (json.loads(file.read_text()) for file in (path, other))
    for one in (mine, theirs):
        del one["provenance"], one["identification"]["record_source"]
    assert mine == theirs


def test_the_joint_is_found(found):
    # Noise of a per mille of the force, 1500 reversals' worth of samples.
    assert abs(found.stiffness.value / 1e5 - 1) < 0.02
    assert found.stiffness.lower <= found.stiffness.value <= found.stiffness.upper
    assert abs(found.joint.force(6e-5) / truth().force(6e-5) - 1) < 0.01
    assert found.records[0].start == "virgin"
    assert found.records[0].scatter == pytest.approx(0.01, rel=0.2)
    assert len(found.draws) == 100
    assert found.viscous is None
    assert found.method == "inversion"


@needs_program
@pytest.mark.parametrize("options", [[], ["--viscous", "fit", "--start", "unknown"]])
def test_it_is_that_of_the_program(tmp_path, options):
    path = os.path.join(DATA, "random.csv")
    run("identify", path, "--out", tmp_path / "joint.json", "--samples", "100", "--seed", "3",
        "--samples-out", tmp_path / "s.h5", *options)  # fmt: skip
    more = {"viscous": True, "start": "unknown"} if options else {}
    mine = microslip.identify_records(
        microslip.read_recordings(path), samples=100, seed=3, strict=False, **more
    )
    mine.write(tmp_path / "mine.json")
    same_json(tmp_path / "mine.json", tmp_path / "joint.json")
    draws = microslip.JointDraws.read(tmp_path / "s.h5")
    np.testing.assert_array_equal(mine.draws.stiffness, draws.stiffness)
    np.testing.assert_array_equal(mine.draws.stiffness_density, draws.stiffness_density)
    assert (mine.viscous is not None) == bool(options)


def test_recordings_are_taken_as_arrays(found):
    force, u = arrays()
    recording = microslip.Recording.of({"F": force, "u": u}, {"F": "N", "u": "m"}, fs=1000)
    mine = microslip.identify_records(recording, samples=100, seed=4)
    same_density(mine.joint, found.joint)
    named = microslip.identify_records(
        recording, force="F", displacement="u", samples=100, seed=4
    )
    same_density(named.joint, found.joint)


def test_levels_and_records_go_together():
    force, u = arrays()
    a = np.linspace(2e-6, 8e-5, 20)
    both = microslip.identify_records(
        force=[force, force], displacement=[u, u], time_step=1e-3, stiffness=1e5, samples=100,
        levels=microslip.Levels(a, truth().dissipation(a), dissipation_std=0.01 * a**2 * 1e4),
        strict=False,
    )  # fmt: skip
    assert both.stiffness.value == 1e5
    assert [fit.source for fit in both.records] == ["arrays 1", "arrays 2"]


def test_a_drift_of_the_displacement_is_taken_off(found):
    force, u = arrays()
    drift = 1e-5 * np.linspace(0, 1, len(u))
    mine = microslip.identify_records(
        force=force, displacement=u + drift, fs=1000, samples=100, seed=4, drift=True
    )
    (fit,) = mine.records
    assert fit.force_drift.size == 0
    assert abs(fit.displacement_drift.sum() / 1e-5 - 1) < 0.1
    assert abs(mine.stiffness.value / found.stiffness.value - 1) < 0.02


def test_results_pickle_and_show(found):
    again = pickle.loads(pickle.dumps(found))
    same_density(again.joint, found.joint)
    assert again.stiffness == found.stiffness
    assert "stiffness" in repr(found)
    assert "<table>" in found._repr_html_()
    assert len(found.to_pandas()) == len(found.slip_force)


def test_work_is_cancelled():
    force, u = arrays()
    with pytest.raises(microslip.Cancelled):
        microslip.identify_records(
            force=force, displacement=u, fs=1000, samples=5000, progress=lambda done, total: False
        )


ONES = np.ones(50)
WAVE = np.sin(np.arange(50.0))
BAD = {
    "nothing": ({}, "force is missing"),
    "no displacement": ({"force": WAVE}, "displacement is missing"),
    "nan": ({"force": WAVE * np.nan, "displacement": WAVE}, r"force\[0\] = nan"),
    "complex": ({"force": WAVE + 1j, "displacement": WAVE}, "force has complex"),
    "empty": ({"force": [], "displacement": WAVE}, "force is empty"),
    "objects": ({"force": WAVE, "displacement": np.array([None] * 50)}, "displacement has Python"),
    "lengths": ({"force": WAVE, "displacement": WAVE[:20]}, "displacement has 20 numbers"),
    "counts": ({"force": [WAVE, WAVE], "displacement": [WAVE]}, "displacement has 1 records"),
    "both rates": ({"force": WAVE, "displacement": WAVE, "fs": 1, "time_step": 1}, "both given"),
    "rate": ({"force": WAVE, "displacement": WAVE, "fs": 0}, "fs = 0"),
    "samples": ({"force": WAVE, "displacement": WAVE, "samples": 5}, "samples = 5"),
    "start": ({"force": WAVE, "displacement": WAVE, "start": "x"}, "start = 'x'"),
    "stiffness": ({"force": WAVE, "displacement": WAVE, "stiffness": -1}, "stiffness = -1"),
    "constant": ({"force": ONES, "displacement": WAVE}, "arrays"),
    "levels": ({"force": WAVE, "displacement": WAVE, "levels": 3}, "levels = 3"),
    "records": ({"records": [1]}, r"records\[0\]"),
    "names": ({"force": "F", "displacement": "u"}, "names of channels"),
    "a rate beside": (
        {"records": microslip.Recording.of({"F": WAVE}, {"F": "N"}, fs=1), "fs": 2}, "fs is given"
    ),
    "no displacement there": (
        {"records": microslip.Recording.of({"F": WAVE}, {"F": "N"}, fs=1)}, "length is missing"
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_named(name):
    arguments, message = BAD[name]
    with pytest.raises(ValueError, match=message):
        microslip.identify_records(**arguments)
