# SPDX-License-Identifier: MIT
"""Several joints at once, and predictions by draws: the same as the program has them."""

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
DATA = os.path.join(os.path.dirname(__file__), "../data/two_joints")
MODEL = os.path.join(DATA, "model.toml")


def levels_in(folder):
    """Every fifth level: what takes the time is their number."""
    with open(os.path.join(DATA, "modal_levels.csv")) as file:
        lines = [line for line in file if not line.startswith("#")]
    path = folder / "modal_levels.csv"
    path.write_text("".join([lines[0], *lines[1::5]]))
    return path


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True, capture_output=True)


def table_of(path):
    """A table of the program by NumPy: numbers and texts as they stand."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    header = lines[0].split(",")
    columns = list(zip(*(line.split(",") for line in lines[1:])))
    return {
        name: np.array(column, dtype=float) if name.endswith("]") else list(column)
        for name, column in zip(header, columns)
    }


@pytest.fixture(scope="module")
def levels(tmp_path_factory):
    return levels_in(tmp_path_factory.mktemp("levels"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory, levels):
    """What the program finds, with its draws."""
    path = tmp_path_factory.mktemp("calibrate") / "out"
    if PROGRAM is None:
        microslip.calibrate(MODEL, levels, samples=100, seed=2, edges=False, out=path, strict=False)
    else:
        run("calibrate", MODEL, levels, "--out", path, "--samples", "100", "--seed", "2", "--edges",
            "none", "--keep-samples")  # fmt: skip
    return path


@pytest.fixture(scope="module")
def calibrated(levels):
    structure, response, _ = microslip._core.read_model_to_find(MODEL)
    structure = microslip.Structure._of(structure)
    measured = microslip.ModalLevels.read(levels, structure)
    return microslip.calibrate(
        structure, measured, response=response, samples=100, seed=2, edges=False, strict=False
    )


def test_it_is_that_of_the_program(calibrated, folder):
    assert [joint.name for joint in calibrated.joints] == ["joint1", "joint2"]
    for joint in calibrated.joints:
        program = microslip.Joint.read(folder / f"{joint.name}.json")
        assert joint.joint.stiffness == program.stiffness
        u = np.linspace(0.0, 1.5 * joint.covered_to / joint.joint.stiffness, 50)
        np.testing.assert_array_equal(joint.joint.force(u), program.force(u))
        draws = microslip.JointDraws.read(folder / f"{joint.name}_samples.h5")
        np.testing.assert_array_equal(joint.draws.stiffness_density, draws.stiffness_density)
    table = table_of(folder / "calibration.csv")
    np.testing.assert_array_equal(calibrated.dissipation, table["dissipation [J]"])
    np.testing.assert_array_equal(calibrated.frequency, table["frequency [Hz]"])
    np.testing.assert_array_equal(calibrated.amplitude[:, 0], table["amplitude_joint1 [m]"])


def test_paths_do_the_same(calibrated, levels, tmp_path):
    of_paths = microslip.calibrate(
        MODEL, [levels], samples=100, seed=2, edges=False, strict=False, out=tmp_path / "out"
    )
    np.testing.assert_array_equal(of_paths["joint2"].density, calibrated["joint2"].density)
    assert sorted(os.listdir(tmp_path / "out")) == [
        "calibration.csv", "calibration.json", "identifiability.csv", "joint1.json",
        "joint1_samples.h5", "joint2.json", "joint2_samples.h5", "model.toml",
    ]  # fmt: skip
    size = microslip.report(tmp_path / "out", tmp_path / "r.html", pictures=False)
    assert size == os.path.getsize(tmp_path / "r.html")


def test_results_pickle_and_show(calibrated):
    again = pickle.loads(pickle.dumps(calibrated))
    np.testing.assert_array_equal(again["joint1"].density, calibrated["joint1"].density)
    assert "joint1" in repr(calibrated)
    assert "<table>" in calibrated["joint1"]._repr_html_()
    assert len(calibrated.to_pandas()) == len(calibrated.found)
    placed = calibrated.structure.joints[0].joint
    assert placed.joint == calibrated["joint1"].joint
    assert placed.covered_to == calibrated["joint1"].covered_to


def test_modal_levels_of_arrays():
    levels = microslip.ModalLevels(
        [0, 0, 1], [1e-5, 2e-5, np.nan_to_num(3e-5)], dissipation=[1e-6, np.nan, 2e-6],
        damping_ratio=[np.nan, 0.01, np.nan],
        joints={"lap": microslip.JointLevels(amplitude=[1e-6, np.nan, 2e-6])},
    )  # fmt: skip
    assert len(levels) == 3
    assert list(levels.to_pandas().columns) == [
        "mode [1]", "displacement [m]", "dissipation [J]", "damping_ratio [1]", "amplitude_lap [m]"
    ]  # fmt: skip
    assert "lap" in repr(levels)


def test_work_is_cancelled(levels):
    with pytest.raises(microslip.Cancelled):
        microslip.calibrate(MODEL, levels, progress=lambda done, total: False)


def test_bad_input_is_named(calibrated, tmp_path):
    structure = calibrated.structure
    u = np.linspace(1e-5, 2e-5, 10)
    levels = microslip.ModalLevels([0] * 10, u, dissipation=np.full(10, 1e-6))
    bad = [
        (lambda: microslip.calibrate(3, levels), "model = 3"),
        (lambda: microslip.calibrate(structure, levels, find=["x"]), r"find\[0\] = 'x'"),
        (lambda: microslip.calibrate(structure, levels, find=[]), "find is empty"),
        (lambda: microslip.calibrate(structure, levels, samples=10), "samples = 10"),
        (lambda: microslip.calibrate(structure, levels, frequency="x"), "frequency = 'x'"),
        (lambda: microslip.calibrate(structure, levels, out=tmp_path), "out is given with arrays"),
        (lambda: microslip.calibrate(structure, None), "paths = None"),
        (lambda: microslip.calibrate(structure, levels, fit_stiffness=True), "absolute"),
        (lambda: microslip.calibrate(structure, levels, response="nowhere"), "nowhere"),
        (lambda: microslip.ModalLevels([0.5], [1e-5]), r"mode\[0\] = 0.5"),
        (lambda: microslip.ModalLevels([0], [1e-5, 1e-5]), "displacement has 2 numbers"),
        (lambda: microslip.ModalLevels([0], None), "displacement is None"),
        (lambda: microslip.ModalLevels([0], [1j]), "displacement has complex"),
        (lambda: microslip.ModalLevels([0], [np.inf]), "displacement"),
        (lambda: microslip.ModalLevels([], []), "mode is empty"),
        (lambda: microslip.report(tmp_path, tmp_path / "r.html"), "folder"),
        (lambda: microslip.report(None, tmp_path / "r.html"), "folder = None"),
        (lambda: microslip.report(tmp_path, tmp_path / "r.html", records=0), "records = 0"),
    ]
    for call, message in bad:
        with pytest.raises(ValueError, match=message):
            call()


@needs_program
def test_the_report_is_that_of_the_program(folder, tmp_path):
    run("report", folder, "--out", tmp_path / "program.html", "--no-pictures")
    microslip.report(folder, tmp_path / "python.html", pictures=False)
    program = (tmp_path / "program.html").read_text()
    python = (tmp_path / "python.html").read_text()
    command = f"microslip report {folder} --out {tmp_path / 'program.html'} --no-pictures --quiet"
    start = program.index("report command")
    assert len(program) - len(python) == len(command) - len("microslip.report"), program[start:][:300]


# ---- Predictions by draws. ----


@pytest.fixture(scope="module")
def predicted():
    return {"samples": 60, "seed": 5, "confidence": 0.9}


@needs_program
def test_bands_of_a_response_are_those_of_the_program(calibrated, folder, tmp_path, predicted):
    run("frf", folder / "model.toml", "--force", "2", "--frequency", "30:36", "--draws", "60",
        "--seed", "5", "--confidence", "0.9", "--out", tmp_path / "frf.csv", "--peaks-csv",
        tmp_path / "peaks.csv")  # fmt: skip
    table, peaks = table_of(tmp_path / "frf.csv"), table_of(tmp_path / "peaks.csv")
    structure = microslip.Structure.read(folder / "model.toml")
    draws = [microslip.JointDraws.read(folder / f"joint{i}_samples.h5") for i in (1, 2)]
    curve = microslip.frequency_response(structure, 2.0, 30.0, 36.0, draws=draws, **predicted)
    np.testing.assert_array_equal(curve.response, table["displacement [m]"])
    np.testing.assert_array_equal(curve.lower, table["lower [m]"])
    np.testing.assert_array_equal(curve.upper, table["upper [m]"])
    assert curve.peak_bands[0].frequency_lower == peaks["frequency_lower [Hz]"][0]
    assert curve.failures == ()
    # In memory, without any file, draws of the calibration belong together as well.
    balance = microslip.HarmonicBalance(calibrated.structure)
    other = balance.frequency_response(2.0, 30.0, 36.0, draws=calibrated.draws, **predicted)
    np.testing.assert_array_equal(other.lower, curve.lower)
    # The number as `draws` and the draws as `samples`, as the options of the program are called.
    as_program = predicted | {"draws": predicted["samples"], "samples": calibrated.draws}
    other = balance.frequency_response(2.0, 30.0, 36.0, **as_program)
    np.testing.assert_array_equal(other.lower, curve.lower)
    again = pickle.loads(pickle.dumps(other))
    np.testing.assert_array_equal(again.upper, curve.upper)


@needs_program
def test_bands_of_a_backbone_are_those_of_the_program(folder, tmp_path, predicted):
    run("backbone", folder / "model.toml", "--response", "1e-5:3e-5:4", "--draws", "60", "--seed",
        "5", "--confidence", "0.9", "--out", tmp_path / "b.csv")  # fmt: skip
    table = table_of(tmp_path / "b.csv")
    structure = microslip.Structure.read(folder / "model.toml")
    draws = {f"joint{i}": microslip.JointDraws.read(folder / f"joint{i}_samples.h5") for i in (1, 2)}
    curve = microslip.backbone(structure, np.linspace(1e-5, 3e-5, 4), draws=draws, **predicted)
    lower, upper = curve.frequency_band
    np.testing.assert_array_equal(lower, table["frequency_lower [Hz]"])
    np.testing.assert_array_equal(upper, table["frequency_upper [Hz]"])
    np.testing.assert_array_equal(curve.damping_ratio_band[0], table["damping_ratio_lower [1]"])


@needs_program
def test_bands_of_a_march_are_those_of_the_program(folder, tmp_path, predicted):
    t = np.arange(200) / 1000
    force = 20 * np.sin(2 * np.pi * 33 * t)
    with open(tmp_path / "f.csv", "w") as file:
        file.write("time [s],force [N]\n")
        file.writelines(f"{time!r},{f!r}\n" for time, f in zip(t.tolist(), force.tolist()))
    run("march", folder / "model.toml", "--force-file", tmp_path / "f.csv", "--draws", "60",
        "--seed", "5", "--confidence", "0.9", "--every", "3", "--out", tmp_path / "m.csv")  # fmt: skip
    table = table_of(tmp_path / "m.csv")
    structure = microslip.Structure.read(folder / "model.toml")
    draws = [microslip.JointDraws.read(folder / f"joint{i}_samples.h5") for i in (1, 2)]
    band = microslip.march_band(structure, t, {"drive": force}, draws=draws, every=3, **predicted)
    np.testing.assert_array_equal(band.time, table["time [s]"])
    for name in ("displacement", "acceleration", "joint2 force"):
        signal = band.signals[name]
        np.testing.assert_array_equal(signal.values, table[f"{name} [{signal.unit}]"])
        np.testing.assert_array_equal(signal.lower, table[f"{name}_lower [{signal.unit}]"])
        np.testing.assert_array_equal(signal.upper, table[f"{name}_upper [{signal.unit}]"])
    # The march itself is that without draws.
    alone = microslip.march(structure, t, {"drive": force}, points=["drive"], every=3)
    np.testing.assert_array_equal(alone.points["drive"].displacement,
                                  band.signals["displacement"].values)  # fmt: skip
    again = pickle.loads(pickle.dumps(band))
    assert again.signals["displacement"].peak == band.signals["displacement"].peak
    assert "peak displacement" in repr(band)
    assert len(band.to_pandas()) == len(band.time)


def small():
    joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    return microslip.HarmonicBalance(
        microslip.Structure(
            [10.0], {"mass": [2**-0.5]}, damping_ratio=0.01,
            joints=[microslip.StructuralJoint(joint, [2**-0.5])],
        )
    )  # fmt: skip


def test_spread_of_a_structure_alone():
    curve = small().constant_response(
        2e-5, 33.0, 38.0, samples=40, spread=microslip.Spread(0.01, normal_load_std=0.1)
    )
    assert isinstance(curve, microslip.ResponseBand)
    assert np.all(curve.lower <= curve.upper)
    assert np.mean((curve.lower <= curve.points.force) & (curve.points.force <= curve.upper)) > 0.9


def test_bad_draws_are_named(calibrated):
    balance = small()
    draws = calibrated["joint1"].draws
    bad = [
        ({"draws": draws}, "samples is 0"),
        ({"samples": 100}, "uncertain"),
        ({"draws": [draws, draws], "samples": 100}, "draws has 2; must have 1"),
        ({"draws": {"x": draws}, "samples": 100}, "draws has 'x'"),
        ({"draws": 3, "samples": 100}, "draws = 3"),
        ({"draws": [3], "samples": 100}, r"draws\[0\] = 3"),
        ({"draws": draws, "samples": 10}, "draws"),
        ({"draws": draws, "samples": 100, "correlation": "x"}, "correlation = 'x'"),
        ({"samples": 100, "spread": 0.1}, "spread = 0.1"),
        ({"samples": 100, "spread": microslip.Spread([0.1, 0.2])}, "frequency_std has 2 numbers"),
        ({"samples": 100, "spread": microslip.Spread(np.nan)}, "frequency_std"),
        ({"samples": 100, "spread": microslip.Spread(-0.1)}, "frequency"),
    ]
    for arguments, message in bad:
        with pytest.raises(ValueError, match=message):
            balance.frequency_response(0.5, 30, 40, **arguments)
    t = np.arange(10) / 100
    for arguments, message in bad[1:]:
        with pytest.raises(ValueError, match=message):
            microslip.march_band(balance.structure, t, **arguments)
    with pytest.raises(ValueError, match="points is given"):
        microslip.march_band(balance.structure, t, points=["mass"])
    with pytest.raises(ValueError, match="samples = 0"):
        microslip.march_band(balance.structure, t, samples=0)
    with pytest.raises(microslip.Cancelled):
        balance.frequency_response(
            0.5, 30, 40, samples=5000, spread=microslip.Spread(0.01),
            progress=lambda done, total: total != 5000,
        )  # fmt: skip
