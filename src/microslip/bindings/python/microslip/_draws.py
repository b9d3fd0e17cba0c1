# SPDX-License-Identifier: MIT
"""Posterior draws of a joint."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Optional, overload

from . import _core
from ._arguments import Path, RealArray, whole
from ._arguments import path as path_of
from ._core import JointDraws as CoreDraws
from ._joint import IdentifiedJoint, Joint
from ._results import Shown, si


class JointDraws(Shown):
    """Posterior draws of a joint: joints that agree with the measurements, each equally likely.

    ``len(draws)`` is their number, ``draws[i]`` the joint of draw i, with its
    own linear damping where that was identified (`IdentifiedJoint`), ``draws[:20]`` a list.
    """

    __slots__ = ("_core",)
    _core: CoreDraws

    def __init__(self) -> None:
        raise TypeError("JointDraws come from an identification, or from JointDraws.read")

    @classmethod
    def _of(cls, core: CoreDraws) -> JointDraws:
        draws = object.__new__(cls)
        draws._core = core
        return draws

    @classmethod
    def read(cls, path: Path) -> JointDraws:
        """Reads the draws of a joint_samples.h5."""
        return cls._of(_core.read_draws(path_of(path, "path")))

    def write(self, path: Path) -> None:
        """Writes a joint_samples.h5: at once and whole, or not at all."""
        name = path_of(path, "path")
        _core.write_file(name, self._core.hdf5(name))

    def __len__(self) -> int:
        return len(self._core)

    @overload
    def __getitem__(self, i: int) -> Joint: ...
    @overload
    def __getitem__(self, i: slice) -> list[Joint]: ...
    def __getitem__(self, i: Any) -> Any:
        if isinstance(i, slice):
            return [self[at] for at in range(*i.indices(len(self)))]
        try:
            number = whole(i, "i", -len(self), len(self) - 1)
        except ValueError:
            raise IndexError(f"draw {i} of {len(self)}") from None
        number %= len(self)
        joint = Joint._of(self._core.joint(number))
        damping = self.linear_damping
        return IdentifiedJoint(joint, float(damping[number])) if len(damping) else joint

    def __iter__(self) -> Iterator[Joint]:
        return (self[i] for i in range(len(self)))

    @property
    def stiffness(self) -> RealArray:
        """k of each draw, N/m."""
        return self._core.stiffness

    @property
    def slip_displacement(self) -> RealArray:
        """Knots x* = f*/k, m, which all draws share."""
        return self._core.slip_displacement

    @property
    def stiffness_density(self) -> RealArray:
        """psi = k**2 phi(k x*) of each draw at the knots, N/m per m; shape (draws, knots)."""
        return self._core.stiffness_density

    @property
    def linear_damping(self) -> RealArray:
        """beta of each draw, J/m**2; empty where it was not identified."""
        return self._core.linear_damping

    def __reduce__(self) -> tuple[Any, ...]:
        return _draws_of, (self._core.state(),)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        k = self.stiffness
        return "Draws of a joint", [
            ("draws", str(len(self))),
            ("method", self._core.method),
            ("seed", str(self._core.seed)),
            ("stiffness", f"{si(k.min(), '1')} to {si(k.max(), 'N/m')}"),
        ]


def _draws_of(state: dict[str, Any]) -> JointDraws:
    return JointDraws._of(_core.draws_of(state))


def draws_or_none(core: Optional[CoreDraws]) -> Optional[JointDraws]:
    return None if core is None else JointDraws._of(core)
