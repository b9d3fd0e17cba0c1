# SPDX-License-Identifier: MIT
"""Bad input: each is a ValueError that names the argument, and never a crash."""

import decimal

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
