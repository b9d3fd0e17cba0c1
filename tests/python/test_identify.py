# SPDX-License-Identifier: MIT
"""Levels and identification: the program's joint.json, tables, draws."""

import dataclasses
import json
import pickle

import numpy as np
import pytest

import microslip

K = 1e5


@pytest.fixture
def levels():
    truth = microslip.Joint(K, [microslip.PowerLaw(0.05, -0.3, 0.0, 9.0)])
    amplitude = np.geomspace(2e-6, 9e-5, 40)
    noise = 1 + 0.01 * np.random.default_rng(1).normal(size=40)
    return microslip.Levels(amplitude, truth.dissipation(amplitude) * noise)


def of_program(program, tmp_path, levels, *options):
    levels.write(tmp_path / "levels.csv")
    program("identify", "levels.csv", "--stiffness", "1e5 N/m", "--out", "by_program.json", *options)
    return json.loads((tmp_path / "by_program.json").read_text())


@pytest.mark.parametrize(
    "options, arguments",
    [
        ({}, []),
        ({"samples": 50, "seed": 7}, ["--samples", "50", "--seed", "7"]),
        ({"linear_damping": True}, ["--linear-damping", "fit"]),
        ({"atom": True, "edges": False}, ["--atom", "--edges", "none"]),
        ({"smoothing": "lambda=0.01"}, ["--smoothing", "lambda=0.01"]),
        ({"fit": "power_law"}, ["--fit", "power_law"]),
        ({"method": "spline", "smoothing": "p=0.99", "smoothing_unit": "um"},
         ["--method", "spline", "--smoothing", "p=0.99", "--smoothing-unit", "um"]),
    ],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore::microslip.MicroslipWarning")
def test_same_bits_as_the_program(program, tmp_path, levels, options, arguments):
    found = microslip.identify(levels, stiffness=K, strict=False, **options)
    found.write(tmp_path / "by_python.json")
    ours = json.loads((tmp_path / "by_python.json").read_text())
    theirs = of_program(program, tmp_path, levels, *arguments)
    for key in ("stiffness_N_per_m", "density", "identification"):
        assert ours[key] == theirs[key]
    # How it came to be differs by the call alone: the levels are the same bytes.
    of_ours, of_theirs = ours["provenance"], theirs["provenance"]
    assert of_ours["options"] == of_theirs["options"]
    assert of_ours["inputs"][0]["sha256"] == of_theirs["inputs"][0]["sha256"]


def test_draws_are_kept(levels, tmp_path):
    found = microslip.identify(levels, stiffness=K, samples=40, seed=3)
    draws = found.draws
    assert len(draws) == 40 and len(list(draws)) == 40
    draws.write(tmp_path / "draws.h5")
    read = microslip.JointDraws.read(tmp_path / "draws.h5")
    again = pickle.loads(pickle.dumps(draws))
    for i in (0, 17, -1):
        assert draws[i] == read[i] == again[i]
    with pytest.raises(IndexError):
        draws[40]
    # The band is made of these draws.
    at = len(found.slip_force) // 2
    values = [draw.density_at(found.slip_force[at]) for draw in draws]
    assert min(values) <= found.lower[at] <= found.upper[at] <= max(values)


def test_finds_the_truth_within_the_band():
    truth = microslip.Joint(K, [microslip.Uniform(0, 8, 0.9)])
    amplitude = np.linspace(2e-6, 1e-4, 60)
    noise = 1 + 0.005 * np.random.default_rng(4).normal(size=60)
    found = microslip.identify(amplitude, truth.dissipation(amplitude) * noise, stiffness=K,
                               samples=200)  # fmt: skip
    force = found.slip_force[(found.slip_force > 0.5) & (found.slip_force < 7.5)]
    inside = [(found.slip_force == f).argmax() for f in force]
    within = (found.lower[inside] <= 0.9 / 8) & (0.9 / 8 <= found.upper[inside])
    # A pointwise band of 95 %, whose points hang together.
    assert within.mean() > 0.85


def test_tables(levels, tmp_path):
    pandas = pytest.importorskip("pandas")
    plain = microslip.identify(levels, stiffness=K)
    frame = levels.to_pandas()
    assert list(frame.columns) == ["amplitude [m]", "dissipation [J]"]
    renamed = frame.rename(columns={"amplitude [m]": "amplitude", "dissipation [J]": "dissipation"})
    mapping = {"amplitude": levels.amplitude, "dissipation": levels.dissipation, "note": "x"}
    for table in (frame, renamed, mapping):
        assert microslip.identify(table, stiffness=K).joint == plain.joint
    with pytest.raises(ValueError, match=r"amplitude \[N\] is in a unit of another quantity"):
        microslip.Levels.of(pandas.DataFrame({"amplitude [N]": [1.0], "dissipation": [1.0]}))
    with pytest.raises(ValueError, match=r"column amplitude \[V\]: unit = 'V'; must be a known unit"):
        microslip.Levels.of({"amplitude [V]": [1.0], "dissipation": [1.0]})
    in_mm = pandas.DataFrame({"amplitude [mm]": [1.0], "dissipation (mJ)": [3.0], "frequency": [5.0]})
    converted = microslip.Levels.of(in_mm)
    assert (converted.amplitude, converted.dissipation, converted.frequency) == (1e-3, 3e-3, 5.0)
    levels.write(tmp_path / "levels.csv")
    read = microslip.Levels.read(tmp_path / "levels.csv")
    assert np.array_equal(read.dissipation, levels.dissipation)
    assert plain.to_pandas().shape == (len(plain.slip_force), 2)


def test_warnings_are_issued_and_kept(levels):
    rising = microslip.Levels(levels.amplitude, levels.dissipation,
                              frequency=np.linspace(50, 51, len(levels)))  # fmt: skip
    with pytest.warns(microslip.MicroslipWarning, match="frequency_rises"):
        found = microslip.identify(rising, stiffness=K)
    assert "frequency_rises" in [note.code for note in found.warnings]
    assert "frequency_rises" in repr(found)
    assert [v.departure for v in found.verdicts if v.broken] == ["frequency_against_dissipation"]


def test_results_are_kept(levels):
    found = microslip.identify(levels, stiffness=K, samples=20)
    again = pickle.loads(pickle.dumps(found))
    assert again.joint == found.joint and again.summary == found.summary
    assert np.array_equal(again.upper, found.upper)
    assert "<table>" in found._repr_html_() and "covered" in repr(found)


def test_levels_of_other_loops_are_left_out_with_a_warning(tmp_path):
    rows = "\n".join(f"{a:.3e},{a * a * 100:.4e},{4 if a < 3e-6 else 2}" for a in np.geomspace(1e-6, 1e-4, 20))
    (tmp_path / "levels.csv").write_text("amplitude [m],dissipation [J],reversals [1]\n" + rows + "\n")
    with pytest.warns(microslip.MicroslipWarning, match="inner reversals"):
        assert len(microslip.Levels.read(tmp_path / "levels.csv")) < 20
    with pytest.warns(microslip.MicroslipWarning, match="inner reversals"):
        assert len(microslip.Levels.read(tmp_path / "levels.csv", use_inner_reversals=True)) == 20
    named = "\n".join(f"{a:.3e},{a * a * 100:.4e},{'ab'[i % 2]}" for i, a in enumerate(np.geomspace(1e-6, 1e-4, 20)))
    (tmp_path / "two.csv").write_text("amplitude [m],dissipation [J],assembly\n" + named + "\n")
    with pytest.raises(ValueError, match="assemblies"):
        microslip.Levels.read(tmp_path / "two.csv")
    assert len(microslip.Levels.read(tmp_path / "two.csv", assemblies="none")) == 20


def test_levels_without_loss_are_refused():
    amplitude = np.geomspace(1e-6, 1e-4, 20)
    with pytest.raises(ValueError, match="dissipation"):
        microslip.identify(amplitude, 0 * amplitude, stiffness=K)


AMPLITUDE = np.geomspace(1e-6, 1e-4, 20)
TABLE = {"amplitude [m]": AMPLITUDE, "dissipation [J]": 100 * AMPLITUDE**2}


def test_tables_say_what_files_say():
    turns = np.where(AMPLITUDE < 3e-6, 4, 2)
    described = {**TABLE, "reversals [1]": turns, "flags": ["", "noisy"] * 10, "assembly": ["a"] * 20}
    with pytest.warns(microslip.MicroslipWarning) as warned:
        levels = microslip.Levels.of(described)
    assert np.array_equal(levels.amplitude, AMPLITUDE[turns == 2])
    texts = [str(warning.message) for warning in warned]
    assert texts[1].startswith("levels_left_out: 5 of 20 levels have inner reversals")
    assert texts[0].startswith("levels_flagged: levels carry flags: noisy (8 of 15)")
    with pytest.warns(microslip.MicroslipWarning, match="inner_reversals_used: 5 of 20"):
        assert len(microslip.Levels.of({**TABLE, "reversals": turns}, use_inner_reversals=True)) == 20
    with pytest.raises(ValueError, match="^reversals is above 2 at all levels"):
        microslip.Levels.of({**TABLE, "reversals": [3] * 20})
    with pytest.raises(ValueError, match="^reversals has 19"):
        microslip.Levels.of({**TABLE, "reversals": [2] * 19})
    several = {**TABLE, "assembly": ["a", "b"] * 10}
    with pytest.raises(ValueError, match="^assembly has 2 names, a, b"):
        microslip.Levels.of(several)
    assert len(microslip.Levels.of(several, assemblies="none")) == 20


@pytest.mark.parametrize("name", ["dissipation_sd", "Amplitude_std", "amplitude_std [m] (1 sigma)",
                                  "disipation_std", "secant_stifness [N/m]", "reversal", "frequencies",
                                  "dissipation std"])  # fmt: skip
def test_mistakes_in_names_of_columns_are_refused(name):
    with pytest.raises(ValueError, match="is no column of levels; did you mean"):
        microslip.Levels.of({**TABLE, name: AMPLITUDE})


def test_other_columns_may_hold_anything():
    of_program = ("source", "force_amplitude [N]", "response_amplitude [m/s^2]", "input_energy [J]",
                  "force_distortion [1]", "mean_displacement [m]", "stiffness [N/m]", "note", "level",
                  "displacement_std [m]", "damping_ratio [1]", "decay_time [s]", "", 7)  # fmt: skip
    assert len(microslip.Levels.of({**TABLE, **{name: object() for name in of_program}})) == 20


def test_columns_stand_once_in_a_table():
    pandas = pytest.importorskip("pandas")
    with pytest.raises(ValueError, match=r"amplitude \[m\] and amplitude are both columns"):
        microslip.Levels.of({**TABLE, "amplitude": AMPLITUDE})
    frame = pandas.DataFrame(TABLE)
    with pytest.raises(ValueError, match="are both columns"):
        microslip.Levels.of(pandas.concat([frame, frame], axis=1))
    both = {**TABLE, "frequency [Hz]": AMPLITUDE, "resonance_frequency (Hz)": 2 * AMPLITUDE}
    assert np.array_equal(microslip.Levels.of(both).frequency, 2 * AMPLITUDE)


def test_levels_are_their_own():
    given = AMPLITUDE.copy()
    levels = microslip.Levels(given, given, frequency=given)
    given[3] = np.nan
    for kept in (levels, pickle.loads(pickle.dumps(levels))):
        for values in (kept.amplitude, kept.dissipation, kept.frequency):
            assert np.array_equal(values, AMPLITUDE)
            with pytest.raises(ValueError, match="read-only"):
                values[3] = 0.0
    assert given.flags.writeable


def test_results_are_read_only(levels):
    found = microslip.identify(levels, stiffness=K, samples=20)
    for values in (found.slip_force, found.density, found.lower, found.upper):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 0.0


def test_picture_has_the_atoms_and_takes_a_label(levels):
    figures = pytest.importorskip("matplotlib.figure")
    found = microslip.identify(levels, stiffness=K)
    for joint, axes in ((found.joint, 1), (microslip.Joint(K, [microslip.Atoms([95.0], [0.5])]), 2)):
        figure = figures.Figure()
        ax = dataclasses.replace(found, joint=joint).plot(figure.subplots(), label="mine")
        assert ax.lines[0].get_label() == "mine"
        assert len(figure.axes) == axes  # the second of the weights
        assert ax.get_xlim()[1] >= joint._core.largest_slip_force
