# SPDX-License-Identifier: MIT
"""Densities, joints and the memory of joints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Protocol, Union, overload

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    Path,
    RealArray,
    not_negative,
    one_of,
    positive,
    real,
    real_array,
    sequence,
    shown,
    whole,
)
from ._arguments import path as path_of
from ._core import Joint as CoreJoint
from ._errors import InputError
from ._plot import plot_density
from ._results import Shown, si, warn

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True)
class Uniform:
    """``phi = weight/(to - from_)`` on ``[from_, to]``.

    Parameters
    ----------
    from_, to : float
        Slip forces, N; ``0 <= from_ < to``.
    weight : float
        Share of the stiffness, 1; 0 or more.
    """

    from_: float
    to: float
    weight: float

    def _tuple(self) -> tuple[Any, ...]:
        return ("uniform", real(self.from_, "from_"), real(self.to, "to"),
                real(self.weight, "weight"))  # fmt: skip


@dataclass(frozen=True)
class PowerLaw:
    """``phi = coefficient * f**exponent`` on ``[from_, to]``, [AR14 (6)].

    Parameters
    ----------
    coefficient : float
        R, N**-(1 + exponent); 0 or more.
    exponent : float
        chi, 1; above -1 where ``from_`` is 0.
    from_, to : float
        Slip forces, N; ``0 <= from_ < to``.
    """

    coefficient: float
    exponent: float
    from_: float
    to: float

    def _tuple(self) -> tuple[Any, ...]:
        return ("power_law", real(self.coefficient, "coefficient"), real(self.exponent, "exponent"),
                real(self.from_, "from_"), real(self.to, "to"))  # fmt: skip


def _of_arrays(part: Any, names: tuple[str, ...]) -> tuple[RealArray, ...]:
    return tuple(real_array(getattr(part, name), name) for name in names)


class _Arrays:
    """Equality and hash of parts that hold arrays."""

    _names: tuple[str, ...] = ()

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and all(
            np.array_equal(getattr(self, name), getattr(other, name)) for name in self._names
        )

    def __hash__(self) -> int:  # equal for integers and floats, and for 0 and -0
        numbers = (np.asarray(getattr(self, name), np.float64) for name in self._names)
        return hash(tuple((array + 0.0).tobytes() for array in numbers))


@dataclass(frozen=True, eq=False)
class PiecewiseLinear(_Arrays):
    """Linear between knots and zero outside of them.

    Parameters
    ----------
    slip_force : array_like
        Slip forces of the knots, N; two at least, 0 or more, rising.
    density : array_like
        1/N; one per knot, 0 or more.
    """

    slip_force: ArrayLike
    density: ArrayLike
    _names = ("slip_force", "density")

    def _tuple(self) -> tuple[Any, ...]:
        return ("piecewise_linear", *_of_arrays(self, self._names))


@dataclass(frozen=True, eq=False)
class Atoms(_Arrays):
    """Finite shares of the stiffness with one slip force each.

    Parameters
    ----------
    slip_force : array_like
        N; above 0.
    weight : array_like
        Share of the stiffness, 1; one per atom, 0 or more.
    """

    slip_force: ArrayLike
    weight: ArrayLike
    _names = ("slip_force", "weight")

    def _tuple(self) -> tuple[Any, ...]:
        return ("atoms", *_of_arrays(self, self._names))


@dataclass(frozen=True)
class FourParameter:
    """Segalman's four-parameter density, J. Appl. Mech. 72 (2005) 752. It must be the only part.

    Parameters
    ----------
    macroslip_force : float
        F_S, N; above 0.
    stiffness : float
        K_T, N/m: that of the joint.
    chi : float
        1; above -1, not above 0.
    beta : float
        1; 0 or more.
    """

    macroslip_force: float
    stiffness: float
    chi: float
    beta: float

    def _tuple(self) -> tuple[Any, ...]:
        return ("four_parameter", real(self.macroslip_force, "macroslip_force"),
                real(self.stiffness, "stiffness"), real(self.chi, "chi"),
                real(self.beta, "beta"))  # fmt: skip


Part = Union[Uniform, PowerLaw, PiecewiseLinear, Atoms, FourParameter]
_PARTS = {"uniform": Uniform, "power_law": PowerLaw, "piecewise_linear": PiecewiseLinear,
          "atoms": Atoms, "four_parameter": FourParameter}  # fmt: skip


class Moments(NamedTuple):
    """Partial moments of a density, ``integral of f**n phi df`` from 0 to s."""

    zeroth: float  #: 1
    first: float  #: N
    second: float  #: N**2


class Response(NamedTuple):
    """Force and tangent stiffness of a joint after a step."""

    force: float  #: N
    tangent: float  #: df/dx in the direction of the step, N/m


#: The usual types of a scalar, for which no array is made.
_NUMBERS = frozenset((float, int, np.float64))


class Joint(Shown):
    """A frictional contact as a parallel-series Iwan model. Immutable.

    Parameters
    ----------
    stiffness : float
        k of the stuck joint, N/m; above 0.
    density : sequence of parts
        `Uniform`, `PowerLaw`, `PiecewiseLinear`, `Atoms`, `FourParameter`, which add up. The
        elastic remainder, which never slips, makes their total weight 1.

    Raises
    ------
    ValueError
        Where a rule is broken; the message names the value.

    Examples
    --------
    >>> import microslip
    >>> joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> joint.force(5e-5)
    3.75
    >>> joint.dissipation([5e-5, 1e-4]).tolist()
    [8.333333333333333e-05, 0.0006666666666666666]
    """

    __slots__ = ("_core",)
    _core: CoreJoint

    def __init__(self, stiffness: float, density: Sequence[Part] = ()) -> None:
        parts = []
        for i, part in enumerate(sequence(density, "density", "parts")):
            if type(part) not in _PARTS.values():
                raise InputError(
                    f"density[{i}] = {shown(part)}; must be a part: {', '.join(_PARTS)}, each a class"
                    " of microslip"
                )
            parts.append(part._tuple())
        self._core = _core.Joint(positive(stiffness, "stiffness"), parts)

    @staticmethod
    def _of(core: CoreJoint) -> Joint:
        joint = object.__new__(Joint)
        joint._core = core
        return joint

    @classmethod
    def four_parameter(cls, macroslip_force: float, stiffness: float, chi: float,
                       beta: float) -> Joint:  # fmt: skip
        """Segalman's four-parameter joint, see `FourParameter`."""
        return Joint(stiffness, [FourParameter(macroslip_force, stiffness, chi, beta)])

    @classmethod
    def read(cls, path: Path) -> Joint:
        """Reads the joint of a joint.json.

        A joint is F(u) alone. Where the file also has an identified linear damping, a warning is
        issued: `IdentifiedJoint.read` keeps it.

        Raises
        ------
        FileError, FormatError, ValueError
            Where the file cannot be read, or is not a joint.
        """
        found = IdentifiedJoint.read(path)
        if found.linear_damping:
            warn(
                f"linear_damping: {path_of(path, 'path')} has a linear damping of"
                f" {found.linear_damping:.4g} J/m^2, which a Joint does not contain."
                " IdentifiedJoint.read keeps it for predictions."
            )
        return found.joint

    def write(self, path: Path) -> None:
        """Writes a joint.json: at once and whole, or not at all."""
        text = _core.joint_json(self._core, "microslip.Joint.write")
        _core.write_file(path_of(path, "path"), text.encode())

    @property
    def stiffness(self) -> float:
        """k, N/m."""
        return self._core.stiffness

    @property
    def density(self) -> tuple[Part, ...]:
        """The parts of the density."""
        return tuple(_PARTS[part[0]](*part[1:]) for part in self._core.parts())

    @property
    def macroslip_force(self) -> float:
        """Force at macro-slip, the largest that the sliders carry, N. [AR14 (1)]"""
        return self._core.macroslip_force

    @property
    def macroslip_displacement(self) -> float:
        """Displacement at which every slider has slipped, m; infinite with an elastic remainder."""
        return self._core.macroslip_displacement

    @property
    def elastic_remainder(self) -> float:
        """Share of the stiffness that never slips, 1."""
        return self._core.elastic_remainder

    def density_at(self, slip_force: ArrayLike) -> Any:
        """The density phi without its atoms, 1/N.

        Parameters
        ----------
        slip_force : float or array_like
            N.

        Returns
        -------
        float or ndarray
            In the shape of `slip_force`.
        """
        return self._each(self._core.density, slip_force, "slip_force")

    def moments(self, slip_force: float = np.inf) -> Moments:
        """Partial moments up to a slip force, N, with its atoms; of the whole density without."""
        limit = float(slip_force) if slip_force == np.inf else real(slip_force, "slip_force")
        return Moments(*self._core.moments(limit))

    @overload
    def force(self, displacement: float) -> float: ...
    @overload
    def force(self, displacement: ArrayLike) -> Any: ...
    def force(self, displacement: Any) -> Any:
        """The force on first loading, F(x), N, odd in x. [AR14 (2)]

        Parameters
        ----------
        displacement : float or array_like
            x, m; of any shape.

        Returns
        -------
        float or ndarray
            In the shape of `displacement`.
        """
        if type(displacement) is float and displacement - displacement == 0.0:
            return self._core.force(displacement)
        return self._each(self._core.force, displacement, "displacement")

    def tangent_stiffness(self, displacement: ArrayLike) -> Any:
        """F'(x) on first loading, N/m; shapes as of `force`. [AR14 (4)]"""
        return self._each(self._core.tangent, displacement, "displacement")

    def dissipation(self, amplitude: ArrayLike) -> Any:
        """D(A), J per cycle of amplitude A [m], 0 or more; shapes as of `force`. [AR14 (7)]"""
        return self._each(self._core.dissipation, amplitude, "amplitude")

    def secant_stiffness(self, amplitude: ArrayLike) -> Any:
        """k_eq(A) of the first harmonic, N/m; shapes as of `force`."""
        return self._each(self._core.secant_stiffness, amplitude, "amplitude")

    def loss_factor(self, amplitude: ArrayLike) -> Any:
        """Loss factor D/(pi k_eq A**2), 1; shapes as of `force`."""
        return self._each(self._core.loss_factor, amplitude, "amplitude")

    def loop(
        self,
        displacement: ArrayLike,
        normal_load: Optional[ArrayLike] = None,
        *,
        law: str = "incremental",
        elements: int = 1000,
    ) -> RealArray:
        """The force along a path that starts from the virgin state at 0.

        Parameters
        ----------
        displacement : array_like
            x, m, shape (n,).
        normal_load : array_like, optional
            p(t) = P_N/P_0, 1, shape (n,); 0 or more. [AR14 App. B] Without it the memory of the
            joint is exact, with it the joint is represented by `elements` Jenkins elements.
        law : {"incremental", "total"}
            How the force of stuck elements follows a change of the load.
        elements : int
            Number of Jenkins elements; 1 to 1000000.

        Returns
        -------
        ndarray
            N, shape (n,).
        """
        path = real_array(displacement, "displacement")
        one_of(law, "law", ("incremental", "total"))
        count = whole(elements, "elements", 1, 1_000_000)
        if normal_load is None:
            return self.memory().march(path)
        load = real_array(normal_load, "normal_load", length=len(path), per="one per displacement")
        return _core.march_under_load(self._core, path, load, count, law)

    def memory(self) -> Memory:
        """A new memory of this joint, in the virgin state."""
        return Memory(self)

    def with_normal_load(self, scale: float) -> Joint:
        """The joint under another constant normal load, `scale` times its present one."""
        return Joint._of(self._core.with_normal_load(positive(scale, "scale")))

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the density over the slip force, by matplotlib."""
        largest = self._core.largest_slip_force or 1.0
        force = np.linspace(0.0, 1.05 * largest, 2001)[1:]
        return plot_density(ax, style, force, self.density_at(force), self._atoms())

    def _atoms(self) -> list[tuple[RealArray, RealArray]]:
        """Slip forces and weights of each part of atoms."""
        return [(part[1], part[2]) for part in self._core.parts() if part[0] == "atoms"]

    @staticmethod
    def _each(function: Any, at: Any, name: str) -> Any:
        if type(at) in _NUMBERS:
            return function(real(at, name))
        array = real_array(at, name, ndim=None)
        if array.ndim == 0:
            return function(real(at, name))
        return function(array.reshape(-1)).reshape(array.shape)

    def __reduce__(self) -> tuple[Any, ...]:
        return Joint, (self.stiffness, self.density)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Joint) and (self.stiffness, self.density) == (
            other.stiffness,
            other.density,
        )

    def __hash__(self) -> int:
        return hash((self.stiffness, self.density))

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        return "Joint", [
            ("stiffness", si(self.stiffness, "N/m")),
            ("density", ", ".join(part[0] for part in self._core.parts()) or "none"),
            ("slips up to", si(self._core.largest_slip_force, "N")),
            ("macro-slip force", si(self.macroslip_force, "N")),
            ("elastic remainder", f"{self.elastic_remainder:.4g}"),
        ]


class IdentifiedJoint(Joint):
    """A joint with the linear damping and the range covered of its identification, for predictions.

    Parameters
    ----------
    joint : Joint
        F(u).
    linear_damping : float, optional
        beta of a loss beta*A**2 in addition to slip, J/m**2; 0 or more.
    covered_to : float, optional
        kA of the highest level, N: predictions that go beyond warn.
    """

    __slots__ = ("covered_to", "linear_damping")
    linear_damping: Optional[float]
    covered_to: Optional[float]

    def __init__(self, joint: Joint, linear_damping: Optional[float] = None,
                 covered_to: Optional[float] = None) -> None:  # fmt: skip
        if not isinstance(joint, Joint):
            raise InputError(f"joint = {shown(joint)}; must be a microslip.Joint")
        if linear_damping is not None:
            linear_damping = not_negative(linear_damping, "linear_damping")
        if covered_to is not None:
            covered_to = positive(covered_to, "covered_to")
        self._core = joint._core
        self.linear_damping = linear_damping
        self.covered_to = covered_to

    @property
    def joint(self) -> Joint:
        """F(u) by itself."""
        return Joint._of(self._core)

    @classmethod
    def read(cls, path: Path) -> IdentifiedJoint:
        """Reads the joint of a joint.json with the results of its identification.

        Raises
        ------
        FileError, FormatError, ValueError
            Where the file cannot be read, or is not a joint.
        """
        core, linear_damping, covered_to = _core.read_joint(path_of(path, "path"))
        return IdentifiedJoint(Joint._of(core), linear_damping, covered_to)

    def __reduce__(self) -> tuple[Any, ...]:
        return IdentifiedJoint, (self.joint, self.linear_damping, self.covered_to)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        _, rows = super()._facts()
        if self.linear_damping is not None:
            rows.append(("linear damping", si(self.linear_damping, "J/m^2")))
        if self.covered_to is not None:
            rows.append(("levels up to", si(self.covered_to, "N")))
        return "Identified joint", rows


class Identified(Protocol):
    """Protocol of identifications, which are taken as joints."""

    @property
    def joint(self) -> Joint: ...
    @property
    def linear_damping(self) -> Optional[float]: ...
    @property
    def covered_to(self) -> Optional[float]: ...


#: A joint, or an identification.
AnyJoint = Union[Joint, Identified]


def identified(joint: object, name: str) -> IdentifiedJoint:
    """A joint or an identification as an `IdentifiedJoint`."""
    if isinstance(joint, IdentifiedJoint):
        return joint
    if isinstance(joint, Joint):
        return IdentifiedJoint(joint)
    if isinstance(joint, type) or not all(
        hasattr(joint, key) for key in ("joint", "linear_damping", "covered_to")
    ):
        raise InputError(f"{name} = {joint!r}; must be a microslip.Joint or an identification")
    found: Any = joint
    return IdentifiedJoint(found.joint, found.linear_damping, found.covered_to)


class Memory:
    """The exact memory of a joint: the reversals of its displacement history, by Madelung's rules.

    `trial` evaluates a step without taking it and `advance` takes it, so that an implicit
    integrator may try any number of steps. A copy (`copy.copy`, or `copy`) is a snapshot.

    Parameters
    ----------
    joint : Joint
        The joint; it starts in the virgin state at 0.

    Examples
    --------
    >>> import microslip
    >>> memory = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)]).memory()
    >>> memory.trial(5e-5)
    Response(force=3.75, tangent=50000.0)
    >>> memory.force
    0.0
    >>> memory.advance(5e-5)
    3.75
    """

    __slots__ = ("_core", "joint")
    joint: Joint

    def __init__(self, joint: Joint) -> None:
        if not isinstance(joint, Joint):
            raise InputError(f"joint = {shown(joint)}; must be a microslip.Joint")
        self.joint = joint
        self._core = _core.Memory(joint._core)

    @property
    def displacement(self) -> float:
        """Present displacement, m."""
        return self._core.displacement

    @property
    def force(self) -> float:
        """Present force, N."""
        return self._core.force

    @property
    def reversals(self) -> RealArray:
        """Displacement [m] and force [N] of the reversals in memory, oldest first; shape
        (n, 2)."""
        return self._core.reversals()

    def trial(self, displacement: float) -> Response:
        """Force [N] and tangent stiffness [N/m] after a step to `displacement` [m], not taken."""
        return Response(*self._core.trial(real(displacement, "displacement")))

    def advance(self, displacement: float) -> float:
        """Takes a step to `displacement` [m]. Returns the force there, N."""
        return self._core.advance(real(displacement, "displacement"))

    def dissipation(self, displacement: float) -> float:
        """Energy that the sliders would dissipate in a step to `displacement` [m], J."""
        return self._core.dissipation(real(displacement, "displacement"))

    def stored_energy(self) -> float:
        """Energy stored in the springs of all elements, J."""
        return self._core.stored_energy()

    def march(self, displacement: ArrayLike) -> RealArray:
        """Takes a step to each displacement [m] in turn. Returns the forces, N, shape (n,)."""
        if type(displacement) is np.ndarray and _plain(displacement):
            return self._core.march(displacement)  # it checks itself that numbers are finite
        return self._core.march(real_array(displacement, "displacement"))

    def reset(self) -> None:
        """Returns to the virgin state at 0."""
        self._core.reset()

    def copy(self) -> Memory:
        """A snapshot."""
        memory = object.__new__(Memory)
        memory.joint = self.joint
        memory._core = self._core.copy()
        return memory

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> Memory:
        return self.copy()  # the joint is immutable

    def __reduce__(self) -> tuple[Any, ...]:
        path = np.append(self.reversals[:, 0], self.displacement)
        return _memory_after, (self.joint, path)

    def __repr__(self) -> str:
        return (
            f"Memory(displacement={self.displacement!r}, force={self.force!r},"
            f" reversals={len(self.reversals)})"
        )


def _plain(array: RealArray) -> bool:
    """Whether the compiled half takes the value as it is."""
    flags = array.flags
    return (array.dtype == np.float64 and array.ndim == 1 and array.size > 0 and flags.c_contiguous
            and flags.aligned)  # fmt: skip


def _memory_after(joint: Joint, path: RealArray) -> Memory:
    """Restores a state by the path over the reversals in its memory."""
    memory = Memory(joint)
    if len(path) > 1 or path[0] != 0.0:
        memory.march(path)
    return memory
