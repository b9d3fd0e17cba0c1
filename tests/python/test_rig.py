# SPDX-License-Identifier: MIT
"""Tests of a rig in memory: the same as the program has them in files."""

import os
import pickle
import shutil
import subprocess

import numpy as np
import pytest

import microslip

# What must be known of small tests is no error here.
pytestmark = pytest.mark.filterwarnings("ignore::microslip.MicroslipWarning")
PROGRAM = os.environ.get("MICROSLIP_PROGRAM")
needs_program = pytest.mark.skipif(PROGRAM is None, reason="MICROSLIP_PROGRAM is not set")
EXAMPLE = os.path.join(os.path.dirname(__file__), "../../examples/reference_rig/rig.toml")


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True, capture_output=True)


def toml():
    """A small test: four levels of half a second."""
    with open(EXAMPLE) as file:
        return file.read().replace("count = 90", "count = 4").replace("duration_s = 1.0", "duration_s = 0.5")


@pytest.fixture(scope="module")
def rig():
    return microslip.Rig.parse(toml())


@pytest.fixture(scope="module")
def joint():
    return microslip.Rig.read(EXAMPLE).true_joint()[0]


@pytest.fixture(scope="module")
def measured(rig, joint):
    return microslip.measure(rig, joint, seed=3, before_control=True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory, joint):
    """The same test by the program."""
    path = tmp_path_factory.mktemp("rig")
    (path / "rig.toml").write_text(toml())
    shutil.copy(os.path.join(os.path.dirname(EXAMPLE), "joint.json"), path)
    if PROGRAM is not None:
        run("measure", path / "rig.toml", "--out", path / "test", "--seed", "3", "--before-control")
    return path


def equal(table, other):
    """The program names records as they were called, with their folder."""
    assert list(table) == list(other)
    for name, column in table.items():
        theirs = [os.path.basename(path) for path in other[name]] if name == "source" else other[name]
        np.testing.assert_array_equal(np.asarray(column), np.asarray(theirs), name)


def records(folder, stem="level"):
    return [microslip.read_recordings(folder / f"test/{stem}_{i:02}.csv")[0] for i in range(1, 5)]


def table_of(path):
    """A table of the program by NumPy: numbers and texts as they stand."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    header = lines[0].split(",")
    columns = list(zip(*(line.split(",") for line in lines[1:])))
    return {
        name: np.array(column, dtype=float)
        if name.endswith("]")
        else [text.strip('"') for text in column]
        for name, column in zip(header, columns)
    }


@needs_program
def test_measure_is_that_of_the_program(measured, folder):
    for stem, mine in (("level", measured.recordings), ("before_control", measured.before_control)):
        for one, other in zip(mine, records(folder, stem)):
            assert [c.name for c in one.channels] == ["force", "acc1", "acc2", "acc3", "ldv"]
            for channel in one.channels:
                np.testing.assert_array_equal(channel.values, other[channel.name].values)
                assert channel.unit == other[channel.name].unit
    truth = table_of(folder / "test/truth.csv")
    truth["source"] = [source.removesuffix(".csv") for source in truth["source"]]
    equal(measured.truth, truth)
    equal(measured.force_control, table_of(folder / "test/force_control.csv"))


@needs_program
def test_reduce_is_that_of_the_program(rig, folder, tmp_path):
    recordings = records(folder)
    run("reduce", folder / "rig.toml", *(folder / f"test/level_{i:02}.csv" for i in range(1, 5)),
        "--out", tmp_path / "levels.csv")  # fmt: skip
    reduced = microslip.reduce(rig, recordings)
    equal(reduced.table, table_of(tmp_path / "levels.csv"))
    reduced.write(tmp_path / "python.csv")
    equal(table_of(tmp_path / "python.csv"), table_of(tmp_path / "levels.csv"))
    read = microslip.Levels.read(tmp_path / "levels.csv")
    of_frame = microslip.Levels.of(reduced.table)
    for name, column in reduced.levels._columns().items():
        np.testing.assert_array_equal(column, getattr(read, name), name)
        if name != "linear_dissipation":  # which a file is not asked for
            np.testing.assert_array_equal(column, getattr(of_frame, name), name)


@needs_program
def test_verify_is_that_of_the_program(rig, joint, folder, tmp_path):
    run("verify", folder / "rig.toml", folder / "joint.json", folder / "test/level_02.csv",
        folder / "test/level_04.csv", "--out", tmp_path / "v.csv", "--harmonics-csv",
        tmp_path / "h.csv", "--histories", tmp_path / "t.csv")  # fmt: skip
    chosen = [records(folder)[i] for i in (1, 3)]
    verified = microslip.verify(rig, folder / "joint.json", chosen)
    equal(verified.table, table_of(tmp_path / "v.csv"))
    equal(verified.harmonics, table_of(tmp_path / "h.csv"))
    equal(verified.histories, table_of(tmp_path / "t.csv"))
    of_joint = microslip.verify(rig, joint, chosen)
    np.testing.assert_array_equal(of_joint.nrmse("force"), verified.nrmse("force"))


@needs_program
def test_draws_of_a_verification_are_those_of_the_program(rig, folder, tmp_path):
    run("verify", folder / "rig.toml", folder / "joint.json", folder / "test/level_03.csv",
        "--draws", "60", "--seed", "5", "--normal-load-std", "0.05", "--frequency-std", "0.002",
        "--force-gain-std", "0.01", "--out", tmp_path / "v.csv")  # fmt: skip
    verified = microslip.verify(
        rig, folder / "joint.json", records(folder)[2], samples=60, seed=5, normal_load_std=0.05,
        frequency_std=0.002, force_gain_std=0.01,
    )  # fmt: skip
    equal(verified.table, table_of(tmp_path / "v.csv"))
    assert verified.failed_draws == 0


def test_the_whole_chain_in_memory(rig, measured):
    reduced = microslip.reduce(rig, measured.recordings)
    # Noise and the ends of a record leave some per mille.
    np.testing.assert_allclose(
        reduced.table["amplitude [m]"], measured.truth["amplitude [m]"], rtol=2e-3
    )
    with pytest.warns(microslip.MicroslipWarning, match="few_levels"):
        found = microslip.identify(reduced.levels, stiffness=rig.stiffness, samples=100)
    verified = microslip.verify(rig, found, measured.recordings[3], draws=found.draws, samples=50)
    assert verified.nrmse("force")[0] < 0.05  # of the density that four levels give
    assert "predicted_response_lower [m/s^2]" in verified.table


def test_results_pickle_and_show(rig, measured):
    reduced = microslip.reduce(rig, measured.recordings)
    for one in (rig, measured, reduced):
        again = pickle.loads(pickle.dumps(one))
        assert repr(again) == repr(one)
        assert "<table>" in again._repr_html_()
    assert pickle.loads(pickle.dumps(rig)).text == rig.text
    assert len(reduced.to_pandas()) == len(reduced) == 4
    np.testing.assert_array_equal(measured.levels.amplitude, measured.truth["amplitude [m]"])


def test_structure_of_a_rig_has_its_frequencies(rig, joint):
    structure = rig.structure(joint)
    # The axial compliance of the beam lies in series with its joint: 1.2e-4 of the frequency.
    np.testing.assert_allclose(structure.stuck_frequencies()[0], rig.stuck_frequencies()[0], rtol=1e-3)
    assert "force" in structure.points


def test_faulty_records_are_left_out(rig, measured):
    quiet = microslip.Recording.of(
        {name: np.zeros(4096) for name in rig.channels},
        {"force": "N", "acc1": "m/s^2", "acc2": "m/s^2", "acc3": "m/s^2", "ldv": "m"},
        fs=8192.0,
        source="quiet",
    )
    with pytest.raises(ValueError, match="quiet"):
        microslip.reduce(rig, [measured.recordings[1], quiet])
    with pytest.warns(microslip.MicroslipWarning):
        reduced = microslip.reduce(rig, [measured.recordings[1], quiet], skip_faulty=True)
    assert [index for index, _ in reduced.rejected] == [1]
    assert len(reduced) == 1


def test_work_is_cancelled(rig, joint, measured):
    for call in (
        lambda: microslip.measure(rig, joint, progress=lambda done, total: False),
        lambda: microslip.verify(rig, joint, list(measured.recordings) * 4, samples=2000,
                                 normal_load_std=0.1, progress=lambda done, total: False),
    ):  # fmt: skip
        with pytest.raises(microslip.Cancelled):
            call()


def test_bad_input_is_named(rig, joint, measured):
    some = measured.recordings[:1]
    lacking = microslip.Recording(some[0].channels[1:], some[0].axis, "lacking")
    wrong = microslip.Recording(
        (microslip.Channel("force", some[0]["force"].values, "m"), *some[0].channels[1:]),
        some[0].axis,
        "wrong",
    )
    bad = [
        (lambda: microslip.measure("rig.toml", joint), "rig = 'rig.toml'"),
        (lambda: microslip.measure(rig, 3.0), "joint = 3.0"),
        (lambda: microslip.measure(rig, joint, seed=-1), "seed = -1"),
        (lambda: microslip.measure(rig, joint, seed=True), "seed"),
        (lambda: microslip.measure(rig, joint, linear_damping=np.nan), "linear_damping = nan"),
        (lambda: microslip.measure(rig), "of no file"),
        (lambda: microslip.reduce(rig, []), "recordings is empty"),
        (lambda: microslip.reduce(rig, None), "recordings = None"),
        (lambda: microslip.reduce(rig, [1]), r"recordings\[0\]"),
        (lambda: microslip.reduce(rig, lacking), "lacking: channel 'force' is missing"),
        (lambda: microslip.reduce(rig, wrong), "wrong: channel 'force' = length"),
        (lambda: microslip.reduce(rig, some, order=0), "order = 0"),
        (lambda: microslip.reduce(rig, some, frequency=1j), "frequency"),
        (lambda: microslip.verify(rig, None, some), "joint = None"),
        (lambda: microslip.verify(rig, joint, some, harmonics=101), "harmonics = 101"),
        (lambda: microslip.verify(rig, joint, some, draws=joint), "draws"),
        (lambda: microslip.verify(rig, joint, some, samples=100), "uncertain"),
        (lambda: microslip.verify(rig, joint, some, samples=3, normal_load_std=0.1), "draws"),
        (lambda: microslip.Rig.parse("schema = 1"), "rig.toml"),
    ]
    for call, message in bad:
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError):
        microslip.Rig()


def test_spread_without_draws_is_refused(rig, joint, measured):
    for name in ("frequency_std", "loss_factor_std", "normal_load_std", "force_gain_std",
                 "acceleration_gain_std"):  # fmt: skip
        with pytest.raises(ValueError, match=f"^samples is 0; .* as {name} is given"):
            microslip.verify(rig, joint, measured.recordings, **{name: 0.01})
        with pytest.raises(ValueError, match=f"^{name} = "):
            microslip.verify(rig, joint, measured.recordings, **{name: -0.01})


def test_identified_joints_bring_their_damping(rig, joint):
    known = microslip.IdentifiedJoint(joint, 30.0, 50.0)
    of_known, of_number = rig.structure(known), rig.structure(joint, linear_damping=30.0)
    other = rig.structure(known, linear_damping=0.0)
    lag = [microslip.HarmonicBalance(s).solve(frequency=55.0, force=0.1).points.phase_lag[0]
           for s in (of_known, of_number, other, rig.structure(joint))]  # fmt: skip
    assert lag[0] == lag[1] != lag[2] == lag[3]
    for bad in (3, None, [joint], joint.__class__):
        with pytest.raises(ValueError, match="^joint = "):
            microslip.verify(rig, bad, [])
        with pytest.raises(ValueError, match="^joint = "):
            rig.structure(bad)
    with pytest.raises(ValueError, match="^channel = "):
        microslip.verify(rig, joint, microslip.measure(rig, joint).recordings[:1]).nrmse(np.zeros(2))
