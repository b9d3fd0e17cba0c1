# SPDX-License-Identifier: MIT
"""Draws of a joint are a sequence."""

import numpy as np
import pytest

import microslip


@pytest.fixture(scope="module")
def draws():
    truth = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    amplitude = np.linspace(2e-6, 1e-4, 40)
    measured = truth.dissipation(amplitude) * (1 + 0.02 * np.random.default_rng(1).normal(size=40))
    return microslip.identify(amplitude, measured, stiffness=1e5, samples=20).draws


def test_slices_are_lists_of_joints(draws):
    assert draws[1:3] == [draws[1], draws[2]]
    assert draws[::-1] == list(draws)[::-1]
    assert draws[20:] == []


def test_numbers_out_of_range_are_index_errors(draws):
    assert draws[-1] == draws[19]
    for i in (20, -21, 1.0):
        with pytest.raises(IndexError, match="of 20"):
            draws[i]
