# SPDX-License-Identifier: MIT
"""Linear structures by their modes, their joints and their excitations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    ComplexArray,
    Path,
    Progress,
    RealArray,
    broadcast,
    complex_array,
    flag,
    mapping,
    names,
    not_negative,
    one_of,
    optional_array,
    positive,
    real,
    real_array,
    sequence,
    shown,
    text,
    whole,
)
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._core import Structure as CoreStructure
from ._errors import InputError
from ._joint import AnyJoint, IdentifiedJoint, Joint, identified
from ._results import Note, Shown, notes, si, warn


@dataclass(frozen=True, eq=False)
class Base:
    """A common motion of all supports, as of a shaker table.

    Parameters
    ----------
    participation : array_like
        Gamma_i = phi_i' M r, kg**0.5; one per mode.
    point_motion : mapping of str to float, optional
        Displacement of each point with a base that moves by 1; 1 where it is not named.
    """

    participation: ArrayLike
    point_motion: Mapping[str, float]

    def __init__(self, participation: ArrayLike,
                 point_motion: Optional[Mapping[str, float]] = None) -> None:  # fmt: skip
        object.__setattr__(self, "participation", participation)
        moved = {} if point_motion is None else mapping(point_motion, "point_motion")
        object.__setattr__(self, "point_motion", dict(moved))


@dataclass(frozen=True, eq=False)
class StructuralJoint:
    """A joint and its place in a structure with modes q_i.

    Parameters
    ----------
    joint : Joint, IdentifiedJoint or Identification
        F(u). An identification also gives its linear damping and the range of its levels, beyond
        which predictions warn.
    shape : array_like
        psi_i, relative displacement across the joint over q_i, kg**-0.5; one per mode.
    name : str, optional
        Unique name; by default ``joint1``, ``joint2``, ...
    spring_in_modes : float
        Stiffness between its ends that the modes were computed with, N/m; 0 or more, for instance k
        where they are those of the stuck structure. It is subtracted.
    series_compliance : float
        Compliance in series with the joint, m/N; 0 or more.
    shortening : array_like, optional
        Gamma_ij of the geometric shortening, 1/(kg m), shape (modes, modes), symmetric. [AR14 (12)]
    linear_damping : float, optional
        beta of a loss beta*A**2 per cycle in addition to F, J/m**2; 0 or more. By default that of
        the identification, else 0.
    """

    joint: AnyJoint
    shape: ArrayLike
    name: Optional[str] = None
    spring_in_modes: float = 0.0
    series_compliance: float = 0.0
    shortening: Optional[ArrayLike] = None
    linear_damping: Optional[float] = None

    def _dict(self, modes: int, name: str) -> dict[str, Any]:
        of = identified(self.joint, f"{name}: joint")
        damping = self.linear_damping
        if damping is None:
            damping = of.linear_damping or 0.0
        shortening = self.shortening
        if shortening is not None:
            array = real_array(shortening, f"{name}: shortening", ndim=2)
            if array.shape != (modes, modes):
                raise InputError(f"{name}: shortening has the shape {array.shape}; must have"
                                 f" {(modes, modes)}, one per pair of modes")  # fmt: skip
            shortening = array.reshape(-1)
        return {
            "name": name,
            "joint": of.joint._core,
            "shape": real_array(self.shape, f"{name}: shape", length=modes, per="one per mode"),
            "spring_in_modes": not_negative(self.spring_in_modes, f"{name}: spring_in_modes"),
            "series_compliance": not_negative(self.series_compliance, f"{name}: series_compliance"),
            "shortening": shortening,
            "linear_damping": not_negative(damping, f"{name}: linear_damping"),
            "covered_to": of.covered_to,
            "identified_damping": of.linear_damping,
        }


#: A place, or places with their complex harmonics s_1, s_2, ... of the common amplitude.
Excitation = Union[str, Mapping[str, ArrayLike]]


class Structure(Shown):
    """A linear structure in modal form, its joints and its excitation. Immutable.

    Parameters
    ----------
    frequency : array_like
        Natural frequencies of the linear part, without the joints, Hz, shape (modes,); 0 for
        rigid-body modes.
    points : mapping of str to array_like
        Named places: mass-normalised shapes, kg**-0.5, one per mode.
    damping_ratio : float or array_like, optional
        zeta of viscous damping, 1; one for all or one per mode. Or
    loss_factor : float or array_like, optional
        eta of hysteretic damping, 1; one for all or one per mode.
    joints : sequence of StructuralJoint
        Joints; may be empty for a linear structure.
    excitation : str or mapping, optional
        The point that is driven, or the base that is accelerated; or such places with the complex
        harmonics s_1, s_2, ... of the common amplitude. By default the first point.
    bases : mapping of str to Base, optional
        Supports that may be accelerated.
    static_loads : mapping of str to float, optional
        Constant forces at points, N, or accelerations of bases, m/s**2.
    static_attachments : int, optional
        How many of the last modes represent the static flexibility of those left out; 0: none are
        left out. By default predictions estimate the effect of missing modes.

    Raises
    ------
    ValueError
        Where a value breaks a rule; the message names it.

    Examples
    --------
    A mass of 2 kg on a spring and a joint:

    >>> import microslip
    >>> joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> structure = microslip.Structure(
    ...     [10.0], {"mass": [2**-0.5]}, damping_ratio=0.01,
    ...     joints=[microslip.StructuralJoint(joint, [2**-0.5])])
    >>> structure.stuck_frequencies().round(3).tolist()
    [36.966]
    """

    __slots__ = ("_core",)
    _core: CoreStructure

    def __init__(
        self,
        frequency: ArrayLike,
        points: Mapping[str, ArrayLike],
        *,
        damping_ratio: Optional[ArrayLike] = None,
        loss_factor: Optional[ArrayLike] = None,
        joints: Sequence[StructuralJoint] = (),
        excitation: Optional[Excitation] = None,
        bases: Optional[Mapping[str, Base]] = None,
        static_loads: Optional[Mapping[str, float]] = None,
        static_attachments: Optional[int] = None,
    ) -> None:
        hertz = real_array(frequency, "frequency")
        modes = len(hertz)
        shapes = _shapes(points, modes)
        law, loss = _damping(damping_ratio, loss_factor, modes)
        linear = {
            "angular_frequency": 2.0 * np.pi * hertz,
            "loss_factor": loss,
            "points": list(shapes.items()),
            "bases": _bases(bases, list(shapes), modes),
            "static_attachments": None if static_attachments is None else
            whole(static_attachments, "static_attachments", 0, max(modes - 1, 0)),
        }
        driven = next(iter(shapes)) if excitation is None else excitation
        loads = {} if static_loads is None else mapping(static_loads, "static_loads")
        self._core = _core.Structure(
            linear,
            _joint_parts(joints, modes),
            _excitations(driven),
            law,
            [(place, real(value, f"static_loads[{place!r}]")) for place, value in loads.items()],
            None,
        )

    @classmethod
    def _of(cls, core: CoreStructure) -> Structure:
        structure = object.__new__(cls)
        structure._core = core
        return structure

    @classmethod
    def read(cls, path: Path) -> Structure:
        """Reads the structure of a model.toml with its joint files. See docs/file_formats.md."""
        return cls._of(_core.read_structure(path_of(path, "path")))

    def with_joints(self, joints: Sequence[Union[AnyJoint, StructuralJoint]]) -> Structure:
        """This structure with other joints.

        Parameters
        ----------
        joints : sequence
            As many as there are, which replace them in order: each a `Joint`, `IdentifiedJoint` or
            `Identification`, or a `StructuralJoint` with its own place. A linear damping from the
            identification of the old joint is dropped; one given in the structure itself stays. Or
            any number of `StructuralJoint`.
        """
        given = sequence(joints, "joints", "joints")
        old = self._core.joints()
        further = self._core.further_data()
        if not all(isinstance(joint, StructuralJoint) for joint in given) and len(given) != len(old):
            raise InputError(f"joints has {len(given)}; must have {len(old)}, one per joint of the"
                             " structure")  # fmt: skip
        further |= {"joint_samples": [], "damping_given": []}
        if len(given) != len(old):
            further["spread"]["normal_load"] = []
        parts = [
            joint if isinstance(joint, StructuralJoint) else _in_place_of(part, joint)
            for joint, part in zip(given, old)
        ] if len(given) == len(old) else given  # fmt: skip
        modes = len(self.angular_frequency)
        return Structure._of(
            _core.Structure(self._core.linear(), _joint_parts(parts, modes), self._core.excitations(),
                            self._core.damping, self._core.static_loads(), further)  # fmt: skip
        )

    @property
    def angular_frequency(self) -> RealArray:
        """omega of the linear part, rad/s, shape (modes,)."""
        array: RealArray = self._core.linear()["angular_frequency"]
        return array

    @property
    def frequency(self) -> RealArray:
        """Natural frequencies of the linear part, Hz, shape (modes,)."""
        return self.angular_frequency / (2.0 * np.pi)

    @property
    def loss_factor(self) -> RealArray:
        """eta of the linear part, 1, shape (modes,); with viscous damping 2 zeta."""
        array: RealArray = self._core.linear()["loss_factor"]
        return array

    @property
    def damping(self) -> str:
        """``"viscous"`` or ``"hysteretic"``."""
        return self._core.damping

    @property
    def points(self) -> dict[str, RealArray]:
        """Mass-normalised shapes by name of the point, kg**-0.5."""
        return dict(self._core.linear()["points"])

    @property
    def joints(self) -> tuple[StructuralJoint, ...]:
        """The joints, in the order given."""
        return tuple(_placed(part) for part in self._core.joints())

    @property
    def base_driven(self) -> bool:
        """Whether it is excited by accelerations of bases, m/s**2, and not by forces, N."""
        return self._core.base_driven

    def stuck_frequencies(self) -> RealArray:
        """Natural frequencies with all joints stuck, Hz, rising: the resonances at small
        amplitude."""
        return self._core.stuck_frequencies() / (2.0 * np.pi)

    def stuck_mode(self, mode: int) -> RealArray:
        """Modal coordinates of stuck mode `index`, of length 1; by frequency, from 0."""
        return self._core.stuck_mode(whole(mode, "mode"))

    def __reduce__(self) -> tuple[Any, ...]:
        core = self._core
        return _structure_of, (core.linear(), self.joints, core.excitations(), core.damping,
                               core.static_loads(), core.further_data())  # fmt: skip

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        stuck = self.stuck_frequencies()
        shown = ", ".join(f"{f:.5g}" for f in stuck[:5]) + (", ..." if len(stuck) > 5 else "")
        rows = [("modes", str(len(self.angular_frequency))), ("damping", self.damping),
                ("points", ", ".join(self.points))]  # fmt: skip
        rows.extend(
            (f"joint {part['name']}", f"k = {si(part['joint'].stiffness, 'N/m')}")
            for part in self._core.joints()
        )
        rows.append(("driven", ", ".join(place for place, _ in self._core.excitations())))
        rows.append(("all joints stuck", f"{shown} Hz"))
        return "Structure", rows


def _placed(part: dict[str, Any]) -> StructuralJoint:
    """A joint of the compiled half as the user gave it."""
    joint = Joint._of(part["joint"])
    damping, reach = part["identified_damping"], part["covered_to"]
    if damping is not None or reach is not None:
        joint = IdentifiedJoint(joint, damping, reach)
    return StructuralJoint(
        joint, part["shape"], part["name"], part["spring_in_modes"],
        part["series_compliance"], part["shortening"], part["linear_damping"],
    )  # fmt: skip


def _in_place_of(part: dict[str, Any], joint: AnyJoint) -> StructuralJoint:
    """A part of the compiled half with its joint replaced."""
    given = part["linear_damping"] != (part["identified_damping"] or 0.0)
    return StructuralJoint(joint, part["shape"], part["name"], part["spring_in_modes"],
                           part["series_compliance"], part["shortening"],
                           part["linear_damping"] if given else None)  # fmt: skip


def _structure_of(linear: Any, joints: Any, excitations: Any, damping: str, loads: Any,
                  further: Any) -> Structure:  # fmt: skip
    parts = _joint_parts(joints, len(linear["angular_frequency"]))
    return Structure._of(_core.Structure(linear, parts, excitations, damping, loads, further))


def _shapes(points: object, modes: int) -> dict[str, RealArray]:
    shapes = {
        name: real_array(shape, f"points[{name!r}]", length=modes, per="one per mode")
        for name, shape in mapping(points, "points").items()
    }
    if not shapes:
        raise InputError("points is empty; must name at least one point")
    return shapes


def _damping(ratio: object, loss: object, modes: int) -> tuple[str, RealArray]:
    if ratio is not None and loss is not None:
        raise InputError("damping_ratio and loss_factor are both given; must be one of them")
    if loss is not None:
        return "hysteretic", broadcast(loss, "loss_factor", modes, "one per mode")
    if ratio is None:
        return "viscous", np.zeros(modes)
    return "viscous", 2.0 * broadcast(ratio, "damping_ratio", modes, "one per mode")


def _bases(bases: object, points: list[str], modes: int) -> list[tuple[str, RealArray, RealArray]]:
    if bases is None:
        return []
    all_of_them = []
    for name, base in mapping(bases, "bases").items():
        if not isinstance(base, Base):
            raise InputError(f"bases[{name!r}] = {shown(base)}; must be a microslip.Base")
        for point in base.point_motion:
            if point not in points:
                raise InputError(f"bases[{name!r}]: point_motion has {point!r}; must name points:"
                                 f" {', '.join(points)}")  # fmt: skip
        motion = np.array(
            [real(base.point_motion.get(point, 1.0), f"point_motion[{point!r}]") for point in points]
        )
        participation = real_array(base.participation, f"bases[{name!r}]: participation",
                                   length=modes, per="one per mode")  # fmt: skip
        all_of_them.append((name, participation, motion))
    return all_of_them


def _joint_parts(joints: object, modes: int) -> list[dict[str, Any]]:
    given = sequence(joints, "joints", "StructuralJoint")
    parts = []
    for i, joint in enumerate(given):
        if not isinstance(joint, StructuralJoint):
            raise InputError(f"joints[{i}] = {shown(joint)}; must be a microslip.StructuralJoint")
        name = f"joint{i + 1}" if joint.name is None else text(joint.name, f"joints[{i}]: name")
        parts.append(joint._dict(modes, name))
    return parts


def _excitations(excitation: object) -> list[tuple[str, ComplexArray]]:
    if isinstance(excitation, str):
        return [(excitation, np.ones(1, dtype=complex))]
    places = mapping(excitation, "excitation")
    return [
        (place, complex_array(np.atleast_1d(np.asarray(numbers)), f"excitation[{place!r}]"))
        for place, numbers in places.items()
    ]


class Compliance(NamedTuple):
    """Static compliance at a place."""

    name: str
    place: str  #: ``"joint"``, ``"point"`` or ``"base"``
    exact: float  #: from the matrices, m/N
    in_modes: float  #: of the modes alone, m/N
    in_model: float  #: of modes and static attachments, m/N


@dataclass(frozen=True, eq=False, repr=False)
class Modes(Shown):
    """The modes of a structure, from matrices.

    Attributes
    ----------
    frequency : ndarray
        Frequencies of the modes, then of static attachments, Hz.
    points : dict of str to ndarray
        Mass-normalised shapes, kg**-0.5.
    joint_shapes : dict of str to ndarray
        psi of each joint, kg**-0.5.
    static_attachments : int
        How many of the last modes are attachments.
    bases : dict of str to Base
        Supports that may be accelerated.
    compliances : tuple of Compliance
        Static compliance of matrices and model at joints and points.
    warnings : tuple of Note
        Warnings that concern the result.
    """

    frequency: RealArray
    points: dict[str, RealArray]
    joint_shapes: dict[str, RealArray]
    static_attachments: int
    bases: dict[str, Base]
    compliances: tuple[Compliance, ...]
    warnings: tuple[Note, ...]
    _springs: dict[str, float]
    _complete: bool  # whether what the modes leave out is known: attached, or nothing

    def structure(
        self,
        joints: Mapping[str, AnyJoint],
        *,
        damping_ratio: Optional[ArrayLike] = None,
        loss_factor: Optional[ArrayLike] = None,
        excitation: Optional[Excitation] = None,
        static_loads: Optional[Mapping[str, float]] = None,
    ) -> Structure:
        """The structure with joints in their places; see `Structure` for the rest.

        Parameters
        ----------
        joints : mapping of str to Joint, IdentifiedJoint or Identification
            One for each name that was given to `modes`.
        """
        named = mapping(joints, "joints")
        if set(named) != set(self.joint_shapes):
            raise InputError(f"joints has {', '.join(named) or 'none'}; must have"
                             f" {', '.join(self.joint_shapes) or 'none'}")  # fmt: skip
        return Structure(
            self.frequency,
            self.points,
            damping_ratio=damping_ratio,
            loss_factor=loss_factor,
            joints=[
                StructuralJoint(named[name], shape, name, spring_in_modes=self._springs[name])
                for name, shape in self.joint_shapes.items()
            ],
            excitation=excitation,
            bases=self.bases,
            static_loads=static_loads,
            static_attachments=self.static_attachments if self._complete else None,
        )

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        count = len(self.frequency) - self.static_attachments
        shown = ", ".join(f"{f:.5g}" for f in self.frequency[: min(count, 8)])
        rows = [("modes", f"{count}: {shown}{', ...' if count > 8 else ''} Hz"),
                ("static attachments", str(self.static_attachments))]  # fmt: skip
        rows.extend((f"{c.place} {c.name}", f"{c.in_model / c.exact:.6f} of its static compliance")
                    for c in self.compliances if c.exact)  # fmt: skip
        rows.extend(("warning", str(note)) for note in self.warnings)
        return "Modes", rows


def modes(
    stiffness: Any,
    mass: Any,
    *,
    points: Mapping[str, int],
    joints: Optional[Mapping[str, tuple[Optional[int], int, float]]] = None,
    held: Sequence[int] = (),
    bases: Optional[Mapping[str, Sequence[int]]] = None,
    count: Optional[int] = None,
    highest_frequency: Optional[float] = None,
    stuck: bool = False,
    attachment: bool = True,
    attached_points: Sequence[str] = (),
    progress: Optional[Progress] = None,
) -> Modes:
    """Computes the modes of a structure from its matrices.

    Parameters
    ----------
    stiffness, mass : array_like or scipy sparse
        K [N/m] and M [kg] without the joints, shape (n, n), symmetric; duplicate entries of sparse
        matrices add up.
    points : mapping of str to int
        The row, from 0, of each place that is driven or measured.
    joints : mapping of str to (row or None, row, float)
        The rows between which a joint sits, None for the ground, and its k, N/m: the displacement
        of the second less that of the first.
    held : sequence of int
        Fixed rows.
    bases : mapping of str to sequence of int
        Rows that move by 1 with a base.
    count : int, optional
        Number of modes, or
    highest_frequency : float, optional
        frequency up to which all are computed, Hz.
    stuck : bool
        Whether the joints are springs of their k while modes are computed.
    attachment : bool
        Whether to add static attachment shapes so that few modes suffice at the joints.
    attached_points : sequence of str
        Points that also get a static attachment shape.
    progress : callable, optional
        Called with (done, total); False cancels.

    Returns
    -------
    Modes

    Raises
    ------
    ValueError
        Where a value breaks a rule, for instance matrices that are not symmetric; the message names
        it.
    """
    size, k_entries = _entries(stiffness, "stiffness")
    mass_size, m_entries = _entries(mass, "mass")
    if size != mass_size:
        raise InputError(f"mass has {mass_size} rows; must have {size}, those of stiffness")
    between = _joints_between(joints or {}, size)
    on_it = {
        "held": [whole(row, f"held[{i}]", 0, size - 1) for i, row in enumerate(held)],
        "points": [(name, whole(row, f"points[{name!r}]", 0, size - 1))
                   for name, row in mapping(points, "points").items()],
        "bases": [(name, [whole(row, f"bases[{name!r}]", 0, size - 1) for row in rows])
                  for name, rows in mapping(bases or {}, "bases").items()],
        "joints": between,
    }  # fmt: skip
    if not on_it["points"]:
        raise InputError("points is empty; must name at least one point")
    highest = None if highest_frequency is None else positive(highest_frequency, "highest_frequency")
    options = {
        "count": None if count is None else whole(count, "count", 1),
        "highest_frequency": highest,
        "stuck": flag(stuck, "stuck"),
        "attachment": flag(attachment, "attachment"),
        "attached_points": names(attached_points, "attached_points"),
    }
    found = _core.compute_modes(size, k_entries, m_entries, on_it, options, progress_of(progress))
    result = _modes_of(found, between, stuck, attachment)
    for note in result.warnings:
        warn(str(note))
    return result


def _modes_of(found: dict[str, Any], between: list[tuple[str, Optional[int], int, float]],
              stuck: bool, attachment: bool) -> Modes:  # fmt: skip
    linear = found["linear"]
    point_names = [name for name, _ in linear["points"]]
    return Modes(
        frequency=linear["angular_frequency"] / (2.0 * np.pi),
        points=dict(linear["points"]),
        joint_shapes={joint[0]: shape for joint, shape in zip(between, found["joint_shapes"])},
        static_attachments=linear["static_attachments"],
        bases={name: Base(participation, dict(zip(point_names, motion)))
               for name, participation, motion in linear["bases"]},
        compliances=tuple(Compliance(*numbers) for numbers in found["compliances"]),
        warnings=notes(found["warnings"]),
        _springs={joint[0]: joint[3] if stuck else 0.0 for joint in between},
        _complete=attachment or len(linear["angular_frequency"]) == found["degrees_of_freedom"],
    )  # fmt: skip


def _joints_between(joints: object, size: int) -> list[tuple[str, Optional[int], int, float]]:
    between = []
    for name, joint in mapping(joints, "joints").items():
        if not isinstance(joint, Sequence) or len(joint) != 3:
            raise InputError(f"joints[{name!r}] = {shown(joint)}; must be (row or None, row, stiffness)")
        first, second, k = joint
        what = f"joints[{name!r}]"
        between.append((name, None if first is None else whole(first, what, 0, size - 1),
                        whole(second, what, 0, size - 1), positive(k, what)))  # fmt: skip
    return between


def _entries(matrix: Any, name: str) -> tuple[int, tuple[Any, Any, RealArray]]:
    """Entries on and below the diagonal, after a check of symmetry."""
    if hasattr(matrix, "tocoo"):
        coo = matrix.tocoo(copy=True)
        coo.sum_duplicates()
        rows, columns, shape = coo.row, coo.col, coo.shape
        values = real_array(coo.data, name, empty=True)
    else:
        array = real_array(matrix, name, ndim=2)
        shape = array.shape
        rows, columns = np.nonzero(array)
        values = array[rows, columns]
    if len(shape) != 2 or shape[0] != shape[1]:
        raise InputError(f"{name} has the shape {shape}; must be square")
    _check_symmetry(rows, columns, values, shape[0], name)
    lower = rows >= columns
    index = np.int32
    return shape[0], (np.ascontiguousarray(rows[lower], index),
                      np.ascontiguousarray(columns[lower], index),
                      np.ascontiguousarray(values[lower]))  # fmt: skip


def _check_symmetry(rows: Any, columns: Any, values: RealArray, size: int, name: str) -> None:
    """Tolerance of symmetry as of matrices in files: 1e-10 of the largest entry, or 0."""
    place = rows.astype(np.int64) * size + columns
    mirror = columns.astype(np.int64) * size + rows
    both, at = np.unique(np.concatenate((place, mirror)), return_inverse=True)
    differences = np.bincount(at, np.concatenate((values, -values)), len(both))
    off = np.abs(differences) > 1e-10 * np.abs(values).max(initial=0.0)
    if not off.any():
        return
    row, column = divmod(int(both[np.argmax(off)]), size)
    raise InputError(f"{name}[{row}, {column}] differs from {name}[{column}, {row}]; must be symmetric."
                     " Take (K + K.T)/2 where the difference is rounding.")  # fmt: skip
