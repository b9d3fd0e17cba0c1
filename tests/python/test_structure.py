# SPDX-License-Identifier: MIT
"""Structures, their vibrations and marches: the program, closed forms, other solvers."""

import pickle
import warnings

import numpy as np
import pytest

import microslip
from conftest import as_printed, columns


def test_structure_of_a_file_is_the_same(structure, model):
    read = microslip.Structure.read(model)
    assert np.array_equal(read.stuck_frequencies(), structure.stuck_frequencies())
    assert read.joints[0].joint == structure.joints[0].joint
    again = pickle.loads(pickle.dumps(structure))
    assert np.array_equal(again.stuck_frequencies(), structure.stuck_frequencies())
    assert again.damping == structure.damping and again.points.keys() == structure.points.keys()


def test_stuck_frequencies_of_the_eigenproblem(structure, joint):
    # diag(omega**2) + k psi psi', by NumPy.
    omega2 = (2 * np.pi * np.array([40.0, 95.0])) ** 2
    psi = np.array([0.25, 0.6])
    eigenvalues = np.linalg.eigvalsh(np.diag(omega2) + joint.stiffness * np.outer(psi, psi))
    np.testing.assert_allclose(structure.stuck_frequencies(), np.sqrt(eigenvalues) / (2 * np.pi),
                               rtol=1e-12)  # fmt: skip


@pytest.mark.parametrize("force", [0.5, 20.0])
def test_frf_has_the_bits_of_the_program(structure, model, program, tmp_path, force):
    program("frf", model, "--force", repr(force), "--frequency", "40:60", "--out", "frf.csv")
    table = columns(tmp_path / "frf.csv")
    curve = microslip.frequency_response(structure, force, 40, 60)
    assert np.array_equal(as_printed(curve.frequency), table["frequency"])
    assert np.array_equal(curve.response, table["displacement"])
    assert np.array_equal(curve.points.joints[0].amplitude, table["amplitude_lap"])
    assert np.array_equal(curve.points.joints[0].dissipation, table["dissipation_lap"])
    assert np.array_equal(curve.points.linear_dissipation, table["linear_dissipation"])
    assert np.array_equal(curve.response[curve.peak_points], curve.peaks.response)


def test_backbone_and_constant_response_have_the_bits_of_the_program(structure, model, program,
                                                                     tmp_path):  # fmt: skip
    program("backbone", model, "--response", "1e-6:1e-5:2", "--out", "b.csv")
    table = columns(tmp_path / "b.csv")
    curve = microslip.backbone(structure, [1e-6, 1e-5])
    assert np.array_equal(curve.frequency, table["frequency"])
    assert np.array_equal(curve.points.force, table["force"])
    assert np.array_equal(curve.points.damping_ratio, table["damping_ratio"])
    program("frf", model, "--response", "1e-5 m", "--frequency", "45:55", "--out", "c.csv")
    table = columns(tmp_path / "c.csv")
    curve = microslip.HarmonicBalance(structure).constant_response(1e-5, 45, 55)
    assert np.array_equal(curve.points.force, table["force"])


def test_march_has_the_bits_of_the_program(structure, model, program, tmp_path):
    t = np.arange(2000) / 4096
    f = 30 * np.sin(2 * np.pi * 50 * t) * np.exp(-2 * t)
    rows = "\n".join(f"{a!r},{b!r}" for a, b in zip(t.tolist(), f.tolist()))
    (tmp_path / "force.csv").write_text("time [s],force [N]\n" + rows + "\n")
    program("march", model, "--force-file", "force.csv", "--out", "m.csv")
    table = columns(tmp_path / "m.csv")
    # As the program's file has the times, which it reads as even.
    result = microslip.march(structure, table["time"], {"drive": f}, points=["drive"])
    assert np.array_equal(result.points["drive"].displacement, table["displacement"])
    assert np.array_equal(result.joints["lap"].force, table["lap force"])


def test_linear_structure_has_its_receptance():
    zeta, f0, m = 0.02, 50.0, 3.0
    structure = microslip.Structure([f0], {"mass": [m**-0.5]}, damping_ratio=zeta)
    balance = microslip.HarmonicBalance(structure, frequencies=[45.0, 50.0, 57.0])
    curve = balance.frequency_response(2.0, 40, 60)
    w, w0 = 2 * np.pi * curve.frequency, 2 * np.pi * f0
    exact = 2.0 / m / np.abs(w0**2 - w**2 + 2j * zeta * w0 * w)
    np.testing.assert_allclose(curve.response, exact, rtol=1e-9)  # of the tolerance, 1e-12, by Q
    assert all(np.any(curve.frequency == f) for f in (45.0, 50.0, 57.0))
    np.testing.assert_allclose(np.abs(curve.displacement("mass")[:, 1]), curve.response, rtol=1e-13)


def test_balance_solves_and_keeps_targets(structure):
    balance = microslip.HarmonicBalance(structure, kind="acceleration")
    one = balance.solve(response=3.0, phase_lag=np.pi / 2)
    assert one.points.response[0] == pytest.approx(3.0, rel=1e-11)
    assert one.points.phase_lag[0] == pytest.approx(np.pi / 2, abs=1e-9)
    same = balance.solve(frequency=one.points.frequency[0], force=one.points.force[0])
    assert same.points.response[0] == pytest.approx(3.0, rel=1e-8)
    again = pickle.loads(pickle.dumps(balance))
    assert np.array_equal(again.solve(response=3.0, phase_lag=np.pi / 2).points.modal, one.points.modal)
    with pytest.raises(ValueError, match="3 of frequency"):
        balance.solve(frequency=1.0, force=1.0, response=1.0)


def test_march_agrees_with_the_balance(joint):
    # After 120 periods e**(-2 pi 120 zeta) = 3e-7 is left of what was free; the joint takes more.
    structure = microslip.Structure(
        [40.0, 95.0], {"drive": [0.7, 0.4], "end": [0.3, -0.8]}, damping_ratio=0.02,
        joints=[microslip.StructuralJoint(joint, [0.25, 0.6])], static_attachments=0,
    )  # fmt: skip
    f = 49.0
    t = np.linspace(0, 120 / f, 120 * 128 + 1)
    result = microslip.march(structure, t, {"drive": 5 * np.cos(2 * np.pi * f * t)}, points=["end"],
                             strict=False)  # fmt: skip
    last = result.points["end"].displacement[-129:-1]
    first = 2 / 128 * abs(np.sum(last * np.exp(-2j * np.pi * np.arange(128) / 128)))
    balance = microslip.HarmonicBalance(structure, "end", harmonics=9)
    steady = balance.solve(frequency=f, force=5.0)
    assert first == pytest.approx(steady.points.response[0], rel=2e-3)


def test_not_converged_holds_what_was_found(structure):
    balance = microslip.HarmonicBalance(structure, max_points=5, accuracy=0)
    with pytest.raises(microslip.NotConverged) as error:
        balance.frequency_response(5.0, 40, 60)
    partial = error.value.result
    assert 0 < len(partial.points) <= 6 and not partial.summary.converged
    assert "NOT CONVERGED" in repr(partial)
    with pytest.warns(microslip.MicroslipWarning, match="not_converged"):
        curve = balance.frequency_response(5.0, 40, 60, strict=False)
    assert np.array_equal(curve.frequency, partial.frequency)
    kept = pickle.loads(pickle.dumps(error.value))
    assert np.array_equal(kept.result.frequency, partial.frequency)


def test_other_joints_in_the_same_places(structure):
    soft = microslip.Joint(1e6, [microslip.Uniform(0, 10, 1)])
    other = structure.with_joints([soft])
    assert other.joints[0].joint == soft and other.joints[0].name == "lap"
    assert np.array_equal(other.joints[0].shape, structure.joints[0].shape)
    assert len(structure.with_joints([]).joints) == 0
    with pytest.raises(ValueError, match="joints has 2; must have 1"):
        structure.with_joints([soft, soft])


def test_modes_of_matrices_against_a_dense_solver():
    scipy_linalg = pytest.importorskip("scipy.linalg")
    sparse = pytest.importorskip("scipy.sparse")
    n = 60
    k = np.diag(np.full(n, 2e6)) - np.diag(np.full(n - 1, 1e6), 1) - np.diag(np.full(n - 1, 1e6), -1)
    m = np.diag(np.linspace(1.0, 2.0, n))
    joint = {"lap": (20, 40, 5e5)}
    for kind in (np.asarray, sparse.csr_matrix, sparse.coo_matrix, sparse.csc_matrix):
        found = microslip.modes(kind(k), kind(m), points={"tip": n - 1}, joints=joint, count=8)
        exact, shapes = scipy_linalg.eigh(k, m)
        np.testing.assert_allclose(found.frequency[:8], np.sqrt(exact[:8]) / (2 * np.pi), rtol=1e-10)
        np.testing.assert_allclose(np.abs(found.points["tip"][:8]), np.abs(shapes[n - 1, :8]),
                                   atol=1e-8)  # fmt: skip
    # With the static attachment the joint gives way as much as by the matrices.
    flexibility = np.linalg.inv(k)
    along = np.zeros(n)
    along[[20, 40]] = -1, 1
    of_joint = found.compliances[0]
    assert of_joint.exact == pytest.approx(along @ flexibility @ along, rel=1e-9)
    assert of_joint.in_model == pytest.approx(of_joint.exact, rel=1e-9)
    found = microslip.modes(k, m, points={"tip": n - 1}, joints=joint, count=20)
    built = found.structure({"lap": microslip.Joint(5e5, [])}, damping_ratio=0.01)
    stuck = np.sqrt(scipy_linalg.eigvalsh(k + 5e5 * np.outer(along, along), m)) / (2 * np.pi)
    np.testing.assert_allclose(built.stuck_frequencies()[:4], stuck[:4], rtol=1e-5)


def test_base_driven_mass_has_its_transmissibility():
    # A mass on a spring on a table: relative motion w = -a/(w0**2 - w**2 + ...), by hand.
    m, f0, zeta = 2.0, 20.0, 0.05
    structure = microslip.Structure(
        [f0], {"mass": [m**-0.5]}, damping_ratio=zeta, bases={"table": microslip.Base([m**0.5])},
        excitation="table",
    )  # fmt: skip
    assert structure.base_driven
    curve = microslip.frequency_response(structure, 1.0, 10, 30, point="mass")
    w, w0 = 2 * np.pi * curve.frequency, 2 * np.pi * f0
    np.testing.assert_allclose(curve.response, 1 / np.abs(w0**2 - w**2 + 2j * zeta * w0 * w), rtol=1e-9)


def test_what_an_identification_found_goes_along(tmp_path):
    # A fitted damping and the reach of the levels: dropped, they would make a prediction wrong without a word.
    truth = microslip.Joint(2.3e6, [microslip.Uniform(0.0, 80.0, 0.9)])
    amplitude = np.geomspace(1e-6, 2e-5, 40)
    loss = truth.dissipation(amplitude) + 3000.0 * amplitude**2
    found = microslip.identify(amplitude, loss, stiffness=2.3e6, linear_damping=True)
    assert found.linear_damping == pytest.approx(3000.0, rel=0.05)

    def placed(joint, **more):
        return microslip.Structure(
            [40.0], {"drive": [0.7]}, damping_ratio=0.002, static_attachments=0,
            joints=[microslip.StructuralJoint(joint, [0.25], **more)],
        )  # fmt: skip

    with_it = placed(found)
    assert with_it.joints[0].linear_damping == found.linear_damping
    assert pickle.loads(pickle.dumps(with_it)).joints[0].joint.covered_to == found.covered_to
    assert placed(found, linear_damping=0.0).joints[0].linear_damping == 0.0
    bare = microslip.backbone(placed(found.joint), [1e-5]).points.joints[0]
    damped = microslip.backbone(with_it, [1e-5]).points.joints[0]
    assert bare.linear_dissipation[0] == 0.0
    # beta*A**2 of the first harmonic; the others have some 1e-4 of the motion.
    lost = found.linear_damping * np.abs(damped.displacement[0, 1]) ** 2
    assert damped.linear_dissipation[0] == pytest.approx(lost, rel=1e-4)
    assert damped.dissipation[0] > bare.dissipation[0] + 0.9 * lost
    with pytest.warns(microslip.MicroslipWarning, match="beyond"):
        microslip.backbone(with_it, [4e-4])
    found.write(tmp_path / "joint.json")
    with pytest.warns(microslip.MicroslipWarning, match="linear_damping"):
        assert microslip.Joint.read(tmp_path / "joint.json") == found.joint
    read = microslip.IdentifiedJoint.read(tmp_path / "joint.json")
    assert (read.linear_damping, read.covered_to) == (found.linear_damping, found.covered_to)
    assert placed(read).joints[0].linear_damping == found.linear_damping
    assert with_it.with_joints([truth]).joints[0].linear_damping == 0.0
    assert with_it.with_joints([read]).joints[0].linear_damping == found.linear_damping


def test_a_pickle_with_too_few_numbers_is_refused(structure):
    """Of another version, or damaged; one number for each of two modes was read beyond the end."""
    rebuild, arguments, *_ = structure.__reduce_ex__(4)
    linear = dict(arguments[0])
    for count in (0, len(linear["loss_factor"]) - 1):
        short = linear | {"loss_factor": linear["loss_factor"][:count]}
        with pytest.raises(ValueError, match=f"loss_factor = {count} values; must have one per mode"):
            rebuild(short, *arguments[1:])


def test_missing_modes_are_reported(joint):
    few = microslip.Structure(
        [40.0, 95.0], {"drive": [0.7, 0.4]}, damping_ratio=0.02,
        joints=[microslip.StructuralJoint(joint, [0.25, 0.6])],
    )  # fmt: skip
    with pytest.warns(microslip.MicroslipWarning, match="modes_missing"):
        curve = microslip.frequency_response(few, 5.0, 40, 60)
    assert "modes_missing" in [note.code for note in curve.warnings]


def chain(count, attachment):
    """Eight masses in a row, held at one end, with a joint to the ground at the other."""
    n = 8
    k = 2e6 * np.eye(n) - 1e6 * (np.eye(n, k=1) + np.eye(n, k=-1))
    k[-1, -1] = 1e6
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the compliance that few modes lack
        found = microslip.modes(k, np.eye(n), points={"middle": 4}, joints={"lap": (None, 7, 1e6)},
                                count=count, attachment=attachment)  # fmt: skip
    lap = microslip.Joint(1e6, [microslip.Uniform(0, 200, 0.8)])
    return found.structure({"lap": lap}, damping_ratio=0.01)


def response_of(chain, force):
    stuck = chain.stuck_frequencies()[0]
    return microslip.frequency_response(chain, force, 0.8 * stuck, 1.1 * stuck)


# What a chain of masses lacks is known where all its modes are there, or attachments: the program
# declares static_attachments then.
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(("count", "attachment", "lacks"),
                         [(8, True, False), (8, False, False), (3, True, False), (3, False, True)])  # fmt: skip
def test_modes_that_are_there_are_not_missing(count, attachment, lacks):
    codes = [note.code for note in response_of(chain(count, attachment), 10.0).warnings]
    assert ("modes_missing" in codes) == lacks


def test_a_warning_with_other_figures_is_shown_once():
    incomplete = chain(3, False)
    with warnings.catch_warnings(record=True) as seen:
        warnings.simplefilter("default")
        curves = [response_of(incomplete, force) for force in (10.0, 11.0, 12.0)]
    texts = [note.text for curve in curves for note in curve.warnings
             if note.code == "modes_missing"]  # fmt: skip
    assert len(set(texts)) > 1
    assert len([one for one in seen if "modes_missing" in str(one.message)]) == 1


def test_warnings_of_other_places_are_others():
    from microslip._results import _WarningText as Text

    assert Text("a: 2.5 % of 1e-07 m") == Text("a: 31 % of -2.1e-08 m")
    assert hash(Text("a: 2.5 %")) == hash(Text("a: 3 %"))
    assert Text("of joint1: 2 %") != Text("of joint2: 2 %")
    assert Text("of '1': 2 %") != Text("of '2': 2 %")
    assert Text("mode 1: 2 %") != Text("mode 2: 2 %")
    assert Text("Level 1 of 8: 2 %") != Text("Level 2 of 8: 2 %")
    assert str(Text("a: 2.5 %")) == "a: 2.5 %"


def test_points_and_joints_of_one_name_are_columns_each(joint):
    pytest.importorskip("pandas")
    structure = microslip.Structure([40.0], {"a": [1.0]}, damping_ratio=0.01, static_attachments=0,
                                    joints=[microslip.StructuralJoint(joint, [0.5], "a")])  # fmt: skip
    moved = microslip.march(structure, np.linspace(0.0, 0.1, 201), velocity=[0.1])
    frame = moved.to_pandas()
    assert list(frame.columns) == ["time [s]", "displacement_a [m]", "velocity_a [m/s]",
                                   "acceleration_a [m/s^2]", "a displacement [m]", "a force [N]"]  # fmt: skip
    assert np.array_equal(frame["displacement_a [m]"], moved.points["a"].displacement)
    assert np.array_equal(frame["a displacement [m]"], moved.joints["a"].displacement)
    for values in (moved.time, moved.points["a"].displacement, moved.joints["a"].force):
        assert not values.flags.writeable


def test_pictures_take_a_label(structure):
    figures = pytest.importorskip("matplotlib.figure")
    moved = microslip.march(structure, [0.0, 1e-3])
    for style, labels in (({}, ["drive", "end"]), ({"label": "mine"}, ["mine", "mine"])):
        ax = moved.plot(figures.Figure().subplots(), **style)
        assert [line.get_label() for line in ax.lines] == labels


def test_base_driven_structures_are_seen_at_their_first_point(joint):
    shaken = microslip.Structure(
        [40.0], {"tip": [1.0], "end": [0.3]}, damping_ratio=0.01, static_attachments=0,
        bases={"g": microslip.Base([1.2])}, excitation={"g": 1.0},
        joints=[microslip.StructuralJoint(joint, [0.5])])  # fmt: skip
    named, plain = (microslip.HarmonicBalance(shaken, *at) for at in (["tip"], []))
    assert repr(plain) == repr(named)
    time = np.linspace(0.0, 0.05, 51)
    band = microslip.march_band(shaken, time, {"g": np.sin(250 * time)}, samples=40,
                                spread=microslip.Spread(frequency_std=0.01))  # fmt: skip
    moved = microslip.march(shaken, time, {"g": np.sin(250 * time)})
    assert np.array_equal(band.signals["displacement"].values, moved.points["tip"].displacement)
