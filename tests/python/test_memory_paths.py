# SPDX-License-Identifier: MIT
"""Paths of all kinds go through a memory alike."""

import numpy as np
import pytest

import microslip

JOINT = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
PATH = 1e-4 * np.array([0.5, 1.0, -0.25, 0.75, -1.0, 0.0])


def read_only(path):
    copy = path.copy()
    copy.setflags(write=False)
    return copy


@pytest.mark.parametrize(
    "kind",
    [list, tuple, read_only, lambda p: np.repeat(p, 2)[::2], lambda p: p.astype(">f8"),
     lambda p: p.astype(np.longdouble), lambda p: np.ma.masked_array(p)],
    ids=["list", "tuple", "read-only", "strided", "big-endian", "long double", "masked array"],
)  # fmt: skip
def test_a_path_of_any_kind_has_the_same_forces(kind):
    one_by_one = JOINT.memory()
    forces = [one_by_one.advance(float(x)) for x in PATH]
    np.testing.assert_allclose(JOINT.memory().march(kind(PATH)), forces, rtol=1e-15, atol=1e-15)
    assert JOINT.memory().march(PATH).tolist() == JOINT.memory().march(kind(PATH)).tolist()


@pytest.mark.parametrize("kind", [np.asarray, list], ids=["array", "list"])
def test_no_step_is_taken_on_a_path_with_what_is_not_finite(kind):
    memory = JOINT.memory()
    memory.advance(1e-5)
    with pytest.raises(ValueError, match=r"displacement\[1\] = nan; must be finite"):
        memory.march(kind([2e-5, np.nan]))
    assert memory.displacement == 1e-5
    for bad in (np.array([]), np.ones((2, 2))):
        with pytest.raises(ValueError, match="displacement"):
            memory.march(bad)
