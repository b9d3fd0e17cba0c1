# SPDX-License-Identifier: MIT
"""Recordings in files and dictionaries, and ring-downs: the same as the program has them."""

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


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments), "--quiet"], check=True, capture_output=True)


def recording():
    n = np.arange(200)
    return microslip.Recording.of(
        {"force": np.sin(n / 7), "acc1": np.cos(n / 7), "plain": n},
        {"force": "lbf", "acc1": "g"},
        fs=1000.0,
        start=0.25,
        source="test",
    )


def same(a, b):
    assert [c.name for c in a.channels] == [c.name for c in b.channels]
    assert (a.axis.unit, a.axis.start, a.axis.step) == (b.axis.unit, b.axis.start, b.axis.step)
    for one, other in zip(a.channels, b.channels):
        assert one.unit == other.unit
        np.testing.assert_array_equal(one.values, other.values)


def test_units_become_si():
    r = recording()
    n = np.arange(200)
    assert r["force"].unit == "N"
    assert r["acc1"].unit == "m/s^2"
    assert r["plain"].unit is None
    # The library multiplies by one factor and divides by another: no rounding but theirs.
    np.testing.assert_array_equal(r["acc1"].values, np.cos(n / 7) * 9.80665)
    np.testing.assert_array_equal(r["plain"].values, n)
    assert r.fs == 1000.0
    assert len(r) == 200
    np.testing.assert_array_equal(r.time, 0.25 + n * 1e-3)


@pytest.mark.parametrize("ending", ["csv", "uff", "mat", "h5"])
def test_files_read_back(tmp_path, ending):
    path = tmp_path / f"r.{ending}"
    microslip.write_recordings(path, recording())
    (back,) = microslip.read_recordings(path)
    same(back, recording())


def test_a_stated_rate_is_that_of_a_file_without_times(tmp_path):
    (tmp_path / "r.csv").write_text("force [N],acc [m/s^2]\n1,2\n3,4\n5,6\n")
    (back,) = microslip.read_recordings(tmp_path / "r.csv", rate=500)
    assert back.fs == 500.0
    microslip.write_recordings(tmp_path / "timed.csv", back)
    with pytest.raises(ValueError, match="has times or a rate of its own"):
        microslip.read_recordings(tmp_path / "timed.csv", rate=500)


def test_universal_file_of_text_has_13_digits(tmp_path):
    microslip.write_recordings(tmp_path / "r.unv", recording(), "uff-ascii")
    (back,) = microslip.read_recordings(tmp_path / "r.unv")
    # E20.12 has 13 significant digits.
    np.testing.assert_allclose(back["acc1"].values, recording()["acc1"].values, rtol=1e-12)


def test_complex_spectra_read_back(tmp_path):
    f = np.arange(1.0, 30.0)
    r = microslip.Recording.of({"h": f * (1 + 2j)}, {"h": "um/N"}, frequency=f)
    for ending in ("csv", "uff", "mat", "h5"):
        microslip.write_recordings(tmp_path / f"r.{ending}", r)
        (back,) = microslip.read_recordings(tmp_path / f"r.{ending}")
        np.testing.assert_array_equal(back["h"].values, r["h"].values)
        np.testing.assert_array_equal(back.frequency, f)


@needs_program
@pytest.mark.parametrize("ending", ["uff", "mat", "csv"])
def test_conversion_is_that_of_the_program(tmp_path, ending):
    (tmp_path / "in.csv").write_text(
        "# serial: 7\ntime [ms],acc1 [g],f\n" + "".join(f"{i},{i * i % 7},{i % 5}\n" for i in range(50))
    )
    run("convert", tmp_path / "in.csv", tmp_path / f"program.{ending}", "--assume-units", "f=lbf")
    found = microslip.read_recordings(tmp_path / "in.csv", assume_units={"f": "lbf"})
    microslip.write_recordings(tmp_path / f"python.{ending}", found)
    assert (tmp_path / f"python.{ending}").read_bytes() == (tmp_path / f"program.{ending}").read_bytes()


def test_sep5_back_and_forth():
    r = recording()
    signals = r.to_sep5()
    assert signals[1]["unit_str"] == "m/s^2"
    assert signals[1]["fs"] == 1000.0
    assert signals[1]["quantity"] == "acceleration"
    assert signals[1]["channel_name"] == signals[1]["name"] == "acc1"
    same(microslip.Recording.from_sep5(signals), r)


def test_sep5_of_others():
    t = np.array([0.0, 0.1, 0.3])
    r = microslip.Recording.from_sep5({"data": [1, 2, 3], "name": "x", "unit_str": "mm", "time": t})
    np.testing.assert_array_equal(r["x"].values, [1e-3, 2e-3, 3e-3])
    np.testing.assert_array_equal(r.time, t)
    with pytest.raises(ValueError, match="no sampling rate"):
        r.fs


def test_datasets_58_back_and_forth():
    r = recording()
    functions = r.to_uff()
    assert functions[0]["type"] == 58
    assert functions[0]["ordinate_axis_units_lab"] == "N"
    np.testing.assert_array_equal(functions[0]["x"], r.time)
    (back,) = microslip.recordings_from_uff(functions)
    same(back, r)


def test_datasets_58_read_as_the_file(tmp_path):
    n = np.arange(50)
    function = {
        "type": 58, "binary": 0, "id1": "NONE", "func_type": 4, "rsp_node": 3, "rsp_dir": 3,
        "ref_node": 1, "ref_dir": -1, "data": n + 1j, "x": n * 0.5, "abscissa_spacing": 1,
        "abscissa_min": 0.0, "abscissa_inc": 0.5, "ordinate_axis_units_lab": "g",
        "orddenom_axis_units_lab": "lbf", "abscissa_spec_data_type": 18,
    }  # fmt: skip
    (r,) = microslip.recordings_from_uff(function)
    assert r.channels[0].name == "point 3 +Z / point 1 -X"
    assert r.channels[0].unit == "kg^-1"
    assert ("function type", "frequency response") in r.channels[0].attributes
    microslip.write_recordings(tmp_path / "r.uff", r)
    (back,) = microslip.read_recordings(tmp_path / "r.uff")
    same(back, r)
    assert back.channels[0].attributes == r.channels[0].attributes


def test_results_pickle_and_show():
    r = pickle.loads(pickle.dumps(recording()))
    same(r, recording())
    assert "acc1" in repr(r)
    assert "acc1" in r._repr_html_()
    assert list(r.to_pandas().columns) == ["force [N]", "acc1 [m/s^2]", "plain"]


N = np.ones(5)
BAD = {
    "nan": (lambda: microslip.Channel("a", [1.0, np.nan]), r"values of 'a'\[1\] = nan"),
    "none": (lambda: microslip.Channel("a", None), "values of 'a' is None"),
    "objects": (lambda: microslip.Channel("a", np.array([None, 1])), "Python objects"),
    "empty": (lambda: microslip.Channel("a", []), "empty"),
    "table": (lambda: microslip.Channel("a", np.ones((2, 2))), "shape 2x2"),
    "texts": (lambda: microslip.Channel("a", ["x"]), "texts"),
    "unit": (lambda: microslip.Channel("a", N, "furlong"), "unit = 'furlong'; must be a known unit"),
    "name": (lambda: microslip.Channel("", N), "name"),
    "fs": (lambda: microslip.Recording.of({"a": N}, fs=0.0), "fs = 0.0; must be positive"),
    "no axis": (lambda: microslip.Recording.of({"a": N}), "neither fs nor time"),
    "complex time": (lambda: microslip.Recording.of({"a": N}, time=N + 1j), "time has complex"),
    "short time": (lambda: microslip.Recording.of({"a": N}, time=[0, 1, 2]), "axis has 3 points"),
    "time falls": (lambda: microslip.Recording.of({"a": N[:3]}, time=[0, 2, 1]), "above 2"),
    "lengths": (lambda: microslip.Recording.of({"a": N, "b": N[:2]}, fs=1), "must be 5"),
    "units": (lambda: microslip.Recording.of({"a": N}, {"b": "m"}, fs=1), "units has 'b'"),
    "sep5 data": (lambda: microslip.Recording.from_sep5({"name": "a"}), "data is missing"),
    "sep5 unit": (
        lambda: microslip.Recording.from_sep5({"name": "a", "data": N, "fs": 1}), "unit_str"
    ),
    "58 data": (lambda: microslip.recordings_from_uff({"type": 58}), "data is missing"),
    "58 x": (lambda: microslip.recordings_from_uff({"data": N, "x": [1]}), "x has 1 numbers"),
    "58 node": (
        lambda: microslip.recordings_from_uff({"data": N, "x": N, "rsp_node": 1.5}), "rsp_node"
    ),
    "several in CSV": (
        lambda: microslip.write_recordings("x.csv", [recording()] * 2), "must be one in a CSV"
    ),
    "ending": (lambda: microslip.write_recordings("x.foo", recording()), "must end in"),
    "format": (lambda: microslip.write_recordings("x.csv", recording(), "foo"), "format = 'foo'"),
    "recordings": (lambda: microslip.write_recordings("x.csv", [1]), r"recordings\[0\] = int"),
    "signal": (lambda: microslip.ring_down(N * np.nan, fs=1, unit="m"), "signal"),
    "signal unit": (lambda: microslip.ring_down(N, fs=1, unit="N"), "unit = 'N'"),
    "no unit": (lambda: microslip.ring_down(N, fs=1), "unit is missing"),
    "channel": (lambda: microslip.ring_down(recording(), "acc9"), "acc9"),
    "band": (lambda: microslip.ring_down(recording(), "acc1", band=(1, 2, 3)), "band has 3"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_named(name):
    call, message = BAD[name]
    with pytest.raises(ValueError, match=message):
        call()


def test_assumed_units_name_the_argument(tmp_path):
    path = tmp_path / "r.csv"
    path.write_text("time [s],a\n0,1\n1,2\n2,3\n")
    assert microslip.read_recordings(path, assume_units={"a": "mm"})[0]["a"].unit == "m"
    with pytest.raises(ValueError, match="assume_units"):
        microslip.read_recordings(path, assume_units={"a": "furlong"})


def test_truncated_files_are_reported(tmp_path):
    path = tmp_path / "r.uff"
    microslip.write_recordings(path, recording(), "uff-ascii")
    whole = path.read_bytes()
    path.write_bytes(whole[: int(0.5 * len(whole))])
    with pytest.raises(microslip.FormatError):
        microslip.read_recordings(path)
    with pytest.warns(microslip.MicroslipWarning, match="truncated"):
        (r, *_) = microslip.read_recordings(path, allow_truncated=True)
    assert any(name == "warning" for name, _ in r.attributes)


def test_reading_is_cancelled(tmp_path):
    path = tmp_path / "r.csv"
    n = np.arange(400_000.0)
    microslip.write_recordings(path, microslip.Recording.of({"a": n, "b": n / 7}, fs=1e3))
    with pytest.raises(microslip.Cancelled):
        microslip.read_recordings(path, progress=lambda done, total: False)


# ---- Ring-down. ----


def decay(zeta=0.01, frequency=50.0, fs=1024.0, seconds=4.0):
    t = np.arange(int(fs * seconds)) / fs
    omega = 2 * np.pi * frequency
    noise = 1e-5 * np.random.default_rng(1).standard_normal(len(t))
    return microslip.Recording.of(
        {"acc1": np.exp(-zeta * omega * t) * np.cos(omega * t) + noise}, {"acc1": "m/s^2"}, fs=fs
    )


def test_ring_down_finds_the_damping():
    found = microslip.ring_down(decay())
    # Noise of 1e-5 of the first amplitude moves no window by more than its own deviation, often.
    off = np.abs(found.damping_ratio - 0.01) / found.damping_ratio_std
    assert np.median(off) < 2.0
    assert found.summary.converged
    assert found.sensors[0].name == "acc1"
    again = pickle.loads(pickle.dumps(found))
    np.testing.assert_array_equal(again.damping_ratio, found.damping_ratio)
    assert "damping ratio" in repr(found)
    assert len(found.to_pandas()) == len(found)


def test_ring_down_of_an_array_is_that_of_a_recording():
    r = decay()
    one = microslip.ring_down(r)
    other = microslip.ring_down(r["acc1"].values, fs=r.fs, unit="m/s^2")
    np.testing.assert_array_equal(one.amplitude, other.amplitude)


@needs_program
def test_ring_down_is_that_of_the_program(tmp_path):
    r = decay()
    microslip.write_recordings(tmp_path / "decay.csv", r)
    run("ringdown", tmp_path / "decay.csv", "--modal-mass", "1.2", "--joint-ratio", "0.3",
        "--loss-factor", "0.001", "--stick-frequency", "50.1", "--joint-stiffness", "1e5",
        "--out", tmp_path / "levels.csv")  # fmt: skip
    (back,) = microslip.read_recordings(tmp_path / "decay.csv")
    found = microslip.ring_down(back).levels(
        1.2, joint_ratio=0.3, loss_factor=0.001, stick_frequency=50.1, joint_stiffness=1e5
    )
    program = microslip.Levels.read(tmp_path / "levels.csv")
    np.testing.assert_array_equal(found.amplitude, program.amplitude)
    np.testing.assert_array_equal(found.dissipation, program.dissipation)
    np.testing.assert_array_equal(found.dissipation_std, program.dissipation_std)
    np.testing.assert_array_equal(found.secant_stiffness, program.secant_stiffness)
    np.testing.assert_array_equal(found.levels().frequency, program.frequency)


def test_damping_levels_have_no_dissipation():
    levels = microslip.ring_down(decay()).levels()
    assert levels.dissipation is None
    with pytest.raises(ValueError, match="modal_mass"):
        levels.levels()
    with pytest.raises(ValueError, match="loss_factor"):
        microslip.ring_down(decay()).levels(loss_factor=0.1)
