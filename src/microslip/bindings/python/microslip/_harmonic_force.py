# SPDX-License-Identifier: MIT
"""The force of a joint in steady vibration, for the user's own harmonic balance."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _core
from ._arguments import ArrayLike, ComplexArray, RealArray, complex_array, shown, whole
from ._errors import InputError
from ._joint import Joint


class HarmonicResponse(NamedTuple):
    """The force of a joint in steady vibration."""

    force: ComplexArray  #: f_0 to f_H, N
    jacobian: RealArray  #: N/m, shape (2H+1, 2H+1): of the real numbers of `real_harmonics`
    lowest: float  #: min x, m
    highest: float  #: max x, m
    reversals: int  #: in a cycle; 2 without inner loops


class HarmonicForce:
    """The harmonics of the force of a joint, with their exact derivatives: the alternating
    frequency/time method with the exact memory of the joint, which rested virgin at x = 0 before.

        x(tau) = Re sum_{n=0}^{H} x_n exp(i n tau)  ->  f(tau) = Re sum_{n=0}^{H} f_n exp(i n tau)

    Immutable. Threads that share one object take turns; one each is faster.

    Parameters
    ----------
    harmonics : int
        H, from 1 to 1000.
    samples : int
        Samples per cycle, from 2 H + 2 to 1e6. The error falls with their fourth power, with their
        third where the density jumps.

    Raises
    ------
    ValueError
        Where a value is out of its range; the message names it.

    Examples
    --------
    >>> import microslip
    >>> joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> found = microslip.HarmonicForce(3).evaluate(joint, [0, 1e-4, 0, 0])
    >>> bool(abs(found.force[1].real / 1e-4 / joint.secant_stiffness(1e-4) - 1) < 1e-6)
    True
    """

    __slots__ = ("_core", "harmonics", "samples")
    harmonics: int
    samples: int

    def __init__(self, harmonics: int, samples: int = 256) -> None:
        self.harmonics = whole(harmonics, "harmonics", 1, 1000)
        self.samples = whole(samples, "samples", 1, 1_000_000)
        self._core = _core.HarmonicForce(self.harmonics, self.samples)

    def evaluate(self, joint: Joint, displacement: ArrayLike) -> HarmonicResponse:
        """The force of a vibration.

        Parameters
        ----------
        joint : Joint
            Any joint.
        displacement : array_like
            x_0 to x_H, m, shape (H + 1,); complex, x_0 real.

        Returns
        -------
        HarmonicResponse
            The jacobian is exact except for terms of the order of samples**-3 where the density
            jumps.
        """
        if not isinstance(joint, Joint):
            raise InputError(f"joint = {shown(joint)}; must be a microslip.Joint")
        x = complex_array(displacement, "displacement")
        if len(x) != self.harmonics + 1:
            raise InputError(f"displacement has {len(x)} numbers; must have {self.harmonics + 1},"
                             " the mean and one per harmonic")  # fmt: skip
        if x[0].imag != 0.0:
            raise InputError(f"displacement[0] = {x[0]}; must be real, the mean")
        force, derivative, lowest, highest, reversals = self._core.evaluate(
            joint._core, real_harmonics(x)
        )
        return HarmonicResponse(complex_harmonics(force), derivative, lowest, highest, reversals)

    def __reduce__(self) -> tuple[Any, ...]:
        return HarmonicForce, (self.harmonics, self.samples)

    def __repr__(self) -> str:
        return f"HarmonicForce({self.harmonics}, samples={self.samples})"


def real_harmonics(harmonics: ComplexArray) -> RealArray:
    """(x_0, Re x_1, Im x_1, ..., Re x_H, Im x_H) of x_0 to x_H."""
    return np.concatenate((harmonics[:1].real, harmonics[1:].view(np.float64)))


def complex_harmonics(numbers: RealArray) -> ComplexArray:
    """The reverse."""
    return np.concatenate((numbers[:1].astype(complex), numbers[1:].view(np.complex128)))
