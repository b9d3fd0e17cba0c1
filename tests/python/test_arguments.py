# SPDX-License-Identifier: MIT
"""Bad input: each is a ValueError that names the argument, and never a crash."""

import decimal
import os

import numpy as np
import pytest

import microslip

BAD_ARRAYS = {
    "None": None,
    "NaN": [1e-5, np.nan],
    "infinite": [1e-5, np.inf],
    "complex": [1e-5 + 0j, 2e-5],
    "text": ["1e-5", "x"],
    "objects": [object(), 1.0],
    "decimals": [decimal.Decimal(1)],
    "ragged": [[1.0], [1.0, 2.0]],
    "truth values": [True, False],
    "dates": np.array(["2026-01-01"], dtype="datetime64[D]"),
    "masked": np.ma.array([1e-5, 2e-5], mask=[False, True]),
    "huge whole numbers": [10**400, 1],
    "mapping": {"a": 1.0},
    "structured": np.zeros(2, dtype=[("a", float)]),
}
BAD_VECTORS = {**BAD_ARRAYS, "empty": [], "two dimensions": [[1e-5, 2e-5]], "a number": 1e-5}
BAD_NUMBERS = {
    "None": None,
    "NaN": np.nan,
    "infinite": -np.inf,
    "complex": 1 + 1j,
    "text": "1e5",
    "array": [1.0, 2.0],
    "truth value": True,
    "object": object(),
    "huge": 10**400,
    "empty": [],
}
BAD_POSITIVE = {**BAD_NUMBERS, "negative": -1.0, "zero": 0.0}
BAD_COUNTS = {"None": None, "half": 1.5, "negative": -1, "text": "3", "truth value": True,
              "huge": 10**30}  # fmt: skip

A = np.linspace(1e-6, 1e-4, 20)
REFERENCE_RIG = os.path.join(os.path.dirname(__file__), "../../examples/reference_rig/rig.toml")


def table(values):
    return pytest.mark.parametrize("bad", values.values(), ids=values.keys())


def refused(name, call):
    with pytest.raises(ValueError, match=rf"^(?:\w+: )?`?{name}(?!\w)"):
        call()


@table(BAD_ARRAYS)
def test_of_arrays_of_any_shape(joint, bad):
    refused("displacement", lambda: joint.force(bad))
    refused("amplitude", lambda: joint.dissipation(bad))
    refused("slip_force", lambda: joint.density_at(bad))


@table(BAD_VECTORS)
def test_of_vectors(joint, structure, bad):
    refused("displacement", lambda: joint.loop(bad))
    refused("displacement", lambda: joint.memory().march(bad))
    refused("amplitude", lambda: microslip.identify(bad, A, stiffness=1e5))
    refused("frequency", lambda: microslip.Structure(bad, {"p": [1.0]}))
    refused(r"points\['p'\]", lambda: microslip.Structure([1.0], {"p": bad}))
    refused("time", lambda: microslip.march(structure, bad))
    refused("response", lambda: microslip.backbone(structure, bad))
    refused(r"forces\['drive'\]", lambda: microslip.march(structure, [0.0, 1.0], {"drive": bad}))


@table({name: bad for name, bad in BAD_VECTORS.items() if bad is not None})
def test_of_vectors_that_may_be_left_out(joint, bad):
    refused("dissipation_std", lambda: microslip.identify(A, A, stiffness=1e5, dissipation_std=bad))
    refused("normal_load", lambda: joint.loop([0.0, 1e-5], bad))


@table(BAD_POSITIVE)
def test_of_positive_numbers(structure, bad):
    refused("stiffness", lambda: microslip.Joint(bad))
    refused("stiffness", lambda: microslip.identify(A, A, stiffness=bad))
    refused("force", lambda: microslip.frequency_response(structure, bad, 80, 120))
    refused("from_", lambda: microslip.frequency_response(structure, 1.0, bad, 120))
    refused("tolerance", lambda: microslip.HarmonicBalance(structure, tolerance=bad))


@table(BAD_NUMBERS)
def test_of_numbers(joint, bad):
    memory = joint.memory()
    memory.advance(1e-5)
    for step in (memory.trial, memory.advance, memory.dissipation):
        refused("displacement", lambda step=step: step(bad))
    assert memory.displacement == 1e-5
    refused("weight", lambda: microslip.Joint(1.0, [microslip.Uniform(0, 1, bad)]))
    refused("scale", lambda: joint.with_normal_load(bad))


@table(BAD_COUNTS)
def test_of_counts(joint, structure, bad):
    refused("harmonics", lambda: microslip.HarmonicBalance(structure, harmonics=bad))
    refused("samples", lambda: microslip.identify(A, A, stiffness=1e5, samples=bad))
    refused("elements", lambda: joint.loop([0.0], elements=bad))
    refused("every", lambda: microslip.march(structure, [0, 1], every=bad))


@table({"None": None, "number": 3, "list": ["inversion"], "unknown": "gvc", "empty": ""})
def test_of_words(structure, bad):
    refused("method", lambda: microslip.identify(A, A, stiffness=1e5, method=bad))
    refused("smoothing", lambda: microslip.identify(A, A, stiffness=1e5, smoothing=bad))
    refused("kind", lambda: microslip.HarmonicBalance(structure, kind=bad))


@table({"number": 5, "text": "ab", "list": ["a"]})
def test_of_mappings(bad):
    refused("point_motion", lambda: microslip.Base([1.0], bad))
    refused("points", lambda: microslip.Structure([1.0], bad))


@table({"a text": "ab", "a number": 3, "numbers": [1]})
def test_of_lists_of_names(bad):
    refused("attached_points", lambda: microslip.modes(
        np.eye(2), np.eye(2), points={"a": 0, "b": 1}, count=1, attached_points=bad))  # fmt: skip


def test_of_matrices_that_are_not_symmetric():
    sparse = pytest.importorskip("scipy.sparse")
    stiffness = np.array([[2e5, -1e5, 0.0], [-1e5, 2e5, -1e5], [0.0, -1e5, 1e5]])

    def of(matrix):
        return microslip.modes(matrix, np.eye(3), points={"a": 0}, count=3)

    exact = of(stiffness).frequency
    for made in (np.array, sparse.csr_matrix):
        one_sided = stiffness.copy()
        one_sided[0, 2] = 1e-9  # rounding, beside 2e5, where its mirror image has no entry
        np.testing.assert_allclose(of(made(one_sided)).frequency, exact, rtol=1e-12)
        one_sided[0, 2] = 1.0
        refused(r"stiffness\[0, 2\]", lambda bad=made(one_sided): of(bad))


def test_of_displacements_that_no_joint_reaches(joint):
    refused("displacement", lambda: joint.memory().advance(1e308))
    refused(r"displacement\[1\]", lambda: joint.loop([0.0, -1e308]))
    refused(r"displacement\[1500\]", lambda: joint.loop(1500 * [0.0] + [1e308], 1501 * [1.0]))


@table({"None": None, "number": 1e5, "text": "joint", "class": microslip.Joint})
def test_of_other_objects(bad):
    refused("joint", lambda: microslip.Memory(bad))
    refused("structure", lambda: microslip.HarmonicBalance(bad))
    refused("structure", lambda: microslip.march(bad, [0, 1]))
    refused(r"joints\[0\]", lambda: microslip.Structure([1.0], {"p": [1.0]}, joints=[bad]))
    refused(r"density\[0\]", lambda: microslip.Joint(1.0, [bad]))
    refused("path", lambda: microslip.Joint.read(bad if bad != "joint" else None))


def test_of_rules_of_the_library(joint, structure):
    refused("dissipation has 19 numbers", lambda: microslip.identify(A, A[1:], stiffness=1e5))
    with pytest.raises(ValueError, match=r"weight = -1"):
        microslip.Joint(1e5, [microslip.Uniform(0, 1, -1)])
    with pytest.raises(ValueError, match="total weight|area"):
        microslip.Joint(1e5, [microslip.Uniform(0, 1, 0.7), microslip.Uniform(0, 1, 0.7)])
    with pytest.raises(ValueError, match="amplitude"):
        microslip.identify(-A, A, stiffness=1e5)
    with pytest.raises(ValueError, match="'drive', 'end'"):
        microslip.HarmonicBalance(structure, "nowhere")
    with pytest.raises(ValueError, match="samples"):
        microslip.identify(A, A, stiffness=1e5, samples=3)
    with pytest.raises(ValueError, match="time"):
        microslip.march(structure, [0.0, 1.0, 0.5])
    with pytest.raises(TypeError, match="stifness"):
        microslip.identify(A, A, stifness=1e5)


K2 = [[2.0, -1.0], [-1.0, 2.0]]


@table({
    "not symmetric": ([[2.0, -1.0], [-1.1, 2.0]], r"stiffness\[[01], [01]\] differs"),
    "not square": ([[2.0, -1.0]], "stiffness has the shape"),
    "NaN": ([[2.0, np.nan], [np.nan, 2.0]], r"stiffness\[0, 1\] = nan"),
    "a vector": ([1.0, 2.0], "stiffness has the shape"),
    "None": (None, "stiffness is None"),
    "of other size": (np.eye(3), "mass has 2 rows; must have 3"),
})  # fmt: skip
def test_of_matrices(bad):
    matrix, message = bad
    with pytest.raises(ValueError, match=message):
        microslip.modes(matrix, np.eye(2), points={"a": 0}, count=1)


def test_of_rows_in_matrices():
    for name, call in {
        r"points\['a'\] = 2": {"points": {"a": 2}},
        r"held\[0\] = -1": {"points": {"a": 0}, "held": [-1]},
        r"joints\['j'\]": {"points": {"a": 0}, "joints": {"j": (0, 1)}},
        r"joints\['j'\] = 9": {"points": {"a": 0}, "joints": {"j": (0, 9, 1.0)}},
        "points is empty": {"points": {}},
    }.items():
        with pytest.raises(ValueError, match=name):
            microslip.modes(K2, np.eye(2), count=1, **call)
    with pytest.raises(ValueError, match="count"):
        microslip.modes(K2, np.eye(2), points={"a": 0})


@table({"text": "no", "number": 0, "None": None, "array": np.array([True, False])})
def test_of_strict_before_any_work(structure, monkeypatch, bad):
    rig = microslip.Rig.read(REFERENCE_RIG)
    for module in ("_identification", "_records", "_march", "_march_band", "_vibration", "_rig",
                   "_ring_down"):  # fmt: skip
        # Work is done there alone.
        monkeypatch.setattr(getattr(microslip, module), "_core", None)
    balance = object.__new__(microslip.HarmonicBalance)
    balance.structure = structure
    for call in (
        lambda: microslip.identify(A, A, stiffness=1e5, strict=bad),
        lambda: microslip.identify_records(force=A, displacement=A, strict=bad),
        lambda: microslip.march(structure, [0.0, 1.0], strict=bad),
        lambda: microslip.march_band(structure, [0.0, 1.0], strict=bad),
        lambda: microslip.measure(rig, strict=bad),
        lambda: microslip.verify(rig, "joint.json", [], strict=bad),
        lambda: microslip.ring_down(A, fs=1.0, unit="m", strict=bad),
        lambda: balance.frequency_response(1.0, 80, 120, strict=bad),
        lambda: balance.constant_response(1e-5, 80, 120, strict=bad),
        lambda: balance.backbone(A, strict=bad),
        lambda: balance.solve(frequency=50.0, force=1.0, strict=bad),
    ):
        refused("strict", call)


@table({"array": np.array(["inversion", "spline"]), "numbers": np.zeros(3), "list": ["total"]})
def test_of_words_that_are_arrays(joint, structure, bad):
    refused("method", lambda: microslip.identify(A, A, stiffness=1e5, method=bad))
    refused("fit", lambda: microslip.identify(A, A, stiffness=1e5, fit=bad))
    refused("kind", lambda: microslip.HarmonicBalance(structure, kind=bad))
    refused("law", lambda: joint.loop([0.0, 1e-5], law=bad))
    refused("law", lambda: microslip.march(structure, [0.0, 1.0], law=bad))
    refused("assemblies", lambda: microslip.Levels.read("levels.csv", assemblies=bad))
    refused("assemblies", lambda: microslip.Levels.of({}, assemblies=bad))


@table({"zero": 0, "list": [], "text": "", "array": np.zeros(2), "False": False})
def test_of_mappings_of_a_march(structure, bad):
    refused("forces", lambda: microslip.march(structure, [0.0, 1.0], bad))
    refused("normal_loads", lambda: microslip.march(structure, [0.0, 1.0], normal_loads=bad))


@table({"number": 5, "text": "drive", "mapping": {"drive": 1}, "numbers": [5], "bytes": b"drive"})
def test_of_names_of_points(structure, bad):
    refused("points", lambda: microslip.march(structure, [0.0, 1.0], points=bad))


def test_names_of_points_may_be_of_any_kind(structure):
    for points in (["end"], ("end",), np.array(["end"]), iter(["end"])):
        assert list(microslip.march(structure, [0.0, 1e-3], points=points).points) == ["end"]


@table({"standard output": "-", "bytes that are no UTF-8": b"\xff.json", "surrogate": "\udcff.json",
        "code 0": "a\0b"})  # fmt: skip
def test_of_paths(joint, capfd, bad):
    levels = microslip.Levels(A, A)
    for call in (joint.write, levels.write, microslip.Joint.read, microslip.Levels.read,
                 microslip.Structure.read):  # fmt: skip
        refused("path", lambda call=call: call(bad))
    # The library never prints.
    assert capfd.readouterr().out == ""


def test_paths_may_be_bytes(joint, tmp_path):
    at = os.fsencode(tmp_path / "é.json")
    joint.write(at)
    assert microslip.Joint.read(at) == joint


def unaligned(values):
    """The same numbers, beginning at an odd byte."""
    values = np.asarray(values)
    room = np.zeros(values.nbytes + 1, dtype=np.uint8)[1:]
    found = room.view(values.dtype).reshape(values.shape)
    found[...] = values
    assert not found.flags.aligned
    return found


def test_arrays_may_be_unaligned(joint):
    odd = unaligned(A)
    assert np.array_equal(joint.force(odd), joint.force(A))
    assert np.array_equal(joint.memory().march(odd), joint.memory().march(A))
    from microslip import _arguments

    for made in (_arguments.real_array(odd, "x"), _arguments.complex_array(unaligned(A + 0j), "x")):
        assert made.flags.aligned and made.flags.c_contiguous and np.array_equal(made, A)
