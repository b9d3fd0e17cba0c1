# SPDX-License-Identifier: MIT
"""Identifies several joints of a structure at once from levels of its modes."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    Path,
    Progress,
    RealArray,
    flag,
    one_of,
    real_array,
    sequence,
    text,
    whole,
)
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._draws import JointDraws
from ._errors import InputError
from ._joint import Joint
from ._plot import plot_identification
from ._records import Estimate
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of
from ._structure import Structure

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

_COLUMNS = {
    "displacement": "m",
    "displacement_std": "m",
    "frequency": "Hz",
    "frequency_std": "Hz",
    "dissipation": "J",
    "dissipation_std": "J",
    "damping_ratio": "1",
    "damping_ratio_std": "1",
}
_OF_JOINT = {"amplitude": "m", "amplitude_std": "m", "dissipation": "J", "dissipation_std": "J"}


def _measured(value: object, name: str, length: int) -> RealArray:
    """Numbers, NaN where something was not measured."""
    array = np.asarray(value)
    gaps = array.dtype.kind == "f" and bool(np.isnan(array).any())
    whole_array = np.where(np.isnan(array), 0.0, array) if gaps else value
    checked = real_array(whole_array, name, length=length, per="one per level")
    return np.where(np.isnan(array), np.nan, checked) if gaps else checked


@dataclass(frozen=True, eq=False)
class JointLevels:
    """Measured quantities of one joint at modal levels, NaN where not measured.

    Parameters
    ----------
    amplitude, amplitude_std : array_like, optional
        Half range of its displacement and its standard deviation, m, shape (n,).
    dissipation, dissipation_std : array_like, optional
        D of this joint alone and its standard deviation, J per cycle, shape (n,).
    """

    amplitude: Optional[ArrayLike] = None
    amplitude_std: Optional[ArrayLike] = None
    dissipation: Optional[ArrayLike] = None
    dissipation_std: Optional[ArrayLike] = None


@dataclass(frozen=True, repr=False, eq=False)
class ModalLevels(Shown):
    """Levels of the resonances of a structure with joints, one entry per level; NaN where something
    was not measured.

    Parameters
    ----------
    mode : array_like of int
        Mode number, ordered by frequency with all joints stuck, from 0, shape (n,).
    displacement : array_like
        Amplitude of the first harmonic at the response point, m, shape (n,); above 0.
    displacement_std, frequency, frequency_std : array_like, optional
        Standard deviation of the displacement, m; resonance frequency at this level and its
        standard deviation, Hz.
    dissipation, dissipation_std : array_like, optional
        D of all joints together and its standard deviation, J per cycle; or
    damping_ratio, damping_ratio_std : array_like, optional
        zeta of structure and joints and its standard deviation, 1; or the dissipation in `joints`.
    joints : mapping of str to JointLevels, optional
        Measured quantities of single joints.

    Raises
    ------
    ValueError
        Where a column is not an array of n numbers; the message names it.
    """

    mode: ArrayLike
    displacement: ArrayLike
    displacement_std: Optional[ArrayLike] = None
    frequency: Optional[ArrayLike] = None
    frequency_std: Optional[ArrayLike] = None
    dissipation: Optional[ArrayLike] = None
    dissipation_std: Optional[ArrayLike] = None
    damping_ratio: Optional[ArrayLike] = None
    damping_ratio_std: Optional[ArrayLike] = None
    joints: Optional[Mapping[str, JointLevels]] = None

    def __post_init__(self) -> None:
        modes = sequence(np.asarray(self.mode).tolist(), "mode", "whole numbers")
        numbers = [whole(mode, f"mode[{i}]") for i, mode in enumerate(modes)]
        if not numbers:
            raise InputError("mode is empty; must have at least one level")
        object.__setattr__(self, "mode", np.array(numbers))
        for name in _COLUMNS:
            value = getattr(self, name)
            if value is not None or name == "displacement":
                column = _measured(value, name, len(numbers))
                object.__setattr__(self, name, column)
        for name, joint in (self.joints or {}).items():
            if not isinstance(joint, JointLevels):
                raise InputError(f"joints[{name!r}] = {joint!r}; must be microslip.JointLevels")

    @classmethod
    def read(cls, paths: Union[Path, Sequence[Path]], structure: Structure) -> ModalLevels:
        """Reads the levels of one or several modal_levels.csv.

        Parameters
        ----------
        paths : path or sequence of path
            Paths of the files.
        structure : Structure
            Structure whose joints the columns name, and whose modes are numbered from 1 in the
            files.
        """
        if not isinstance(structure, Structure):
            raise InputError(f"structure = {structure!r}; must be a microslip.Structure")
        return cls._of(_core.read_modal_levels(_paths(paths, "paths"), structure._core))

    @classmethod
    def _of(cls, found: dict[str, Any]) -> ModalLevels:
        joints = {name: JointLevels(*columns) for name, *columns in found.pop("joints")}
        return cls(**found, joints=joints)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of modal_levels.csv; modes are numbered from 1, as there."""
        import pandas

        columns: dict[str, Any] = {"mode [1]": np.asarray(self.mode) + 1}
        for name, unit in _COLUMNS.items():
            if getattr(self, name) is not None:
                columns[f"{name} [{unit}]"] = getattr(self, name)
        for joint, levels in (self.joints or {}).items():
            for name, unit in _OF_JOINT.items():
                if getattr(levels, name) is not None:
                    base, _, std = name.partition("_")
                    columns[f"{base}_{joint}{'_std' if std else ''} [{unit}]"] = getattr(levels, name)
        return pandas.DataFrame(columns)

    def __len__(self) -> int:
        return len(np.asarray(self.mode))

    def _dict(self) -> dict[str, Any]:
        joints = []
        for name, levels in (self.joints or {}).items():
            of_joint = [None if (value := getattr(levels, column)) is None else
                        _measured(value, f"joints[{name!r}]: {column}", len(self))
                        for column in _OF_JOINT]  # fmt: skip
            joints.append((text(name, "a name in joints"), *of_joint))
        columns = {name: getattr(self, name) for name in _COLUMNS}
        return {**columns, "mode": np.asarray(self.mode).tolist(), "joints": joints}

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        u: RealArray = np.asarray(self.displacement)
        modes = sorted(set(np.asarray(self.mode).tolist()))
        return "Modal levels", [
            ("levels", str(len(self))),
            ("modes", ", ".join(map(str, modes)) + " (from 0)"),
            ("displacement", f"{si(float(u.min()), '1')} to {si(float(u.max()), 'm')}"),
            ("joints", ", ".join(self.joints or {}) or "none measured singly"),
        ]


class Edge(NamedTuple):
    """A slip force at which a density jumps."""

    slip_force: float  #: N
    deviation: float  #: its standard deviation, N


class JointPair(NamedTuple):
    """How well the levels distinguish two joints."""

    first: str
    second: str
    correlation: float  #: of their D over the draws, median over the levels, 1
    spread_alone: float  #: of D of the better determined joint, relative, 1
    spread_together: float  #: of the sum of both D, relative, 1
    known_only_together: bool  #: whether only the sum of both D is determined


@dataclass(frozen=True, repr=False, eq=False)
class CalibratedJoint(Shown):
    """An identified joint.

    Attributes
    ----------
    name : str
        Name of the joint in the structure.
    joint : Joint
        Mean of the posterior draws.
    slip_force, density, lower, upper : ndarray
        N and 1/N, shape (knots,): the density with the band that holds 95 % of the draws.
    variance_reduction : ndarray
        Variance reduction of the density, share of the prior variance that the levels removed, 1,
        shape (knots,): 0 where they determine nothing.
    loss_significance : float
        Largest ratio over the levels of its loss to the standard deviation of that loss, 1.
    stiffness, elastic_stiffness : Estimate
        k, and the part of it that does not slip within the levels, N/m.
    edges : tuple of Edge
        Slip forces at which the density jumps.
    covered_from, covered_to : float
        kA of the lowest and the highest level, N.
    draws : JointDraws
        Draw i of one joint belongs to draw i of the others.
    """

    name: str
    joint: Joint
    slip_force: RealArray
    density: RealArray
    lower: RealArray
    upper: RealArray
    variance_reduction: RealArray
    loss_significance: float
    stiffness: Estimate
    elastic_stiffness: Estimate
    edges: tuple[Edge, ...]
    covered_from: float
    covered_to: float
    draws: JointDraws

    @property
    def told(self) -> RealArray:
        """`variance_reduction` by its earlier name."""
        return self.variance_reduction

    @property
    def loss_told(self) -> float:
        """`loss_significance` by its earlier name."""
        return self.loss_significance

    @property
    def linear_damping(self) -> Optional[float]:
        """None: a calibration identifies no loss other than slip."""
        return None

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of identifiability.csv."""
        import pandas

        return pandas.DataFrame(
            {"slip_force [N]": self.slip_force, "density [1/N]": self.density,
             "lower [1/N]": self.lower, "upper [1/N]": self.upper,
             "told [1]": self.variance_reduction}
        )  # fmt: skip

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the density with its band, by matplotlib."""
        return plot_identification(
            ax, style, self.slip_force, self.density, self.joint._atoms(),
            band=(self.lower, self.upper), covered_from=self.covered_from,
            up_to=max(self.covered_to, 1.05 * self.joint._core.largest_slip_force),
        )  # fmt: skip

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        k = self.stiffness
        return f"Joint {self.name}", [
            ("stiffness", f"{si(k.value, 'N/m')}, {k.lower:.5g} to {k.upper:.5g}"),
            ("covered", f"{si(self.covered_from, '1')} to {si(self.covered_to, 'N')}"),
            ("elastic remainder", f"{self.joint.elastic_remainder:.4g}"),
            ("variance reduction", f"up to {100 * float(self.variance_reduction.max()):.3g} %"),
            ("draws", str(len(self.draws))),
        ]


@dataclass(frozen=True, repr=False, eq=False)
class Calibration(Shown):
    """Joints of a structure identified from levels of its modes; ``calibration["lap"]`` is one.

    Attributes
    ----------
    joints : tuple of CalibratedJoint
        The identified joints, in the order of the structure.
    structure : Structure
        The structure with these joints.
    found : ndarray of bool
        Whether the structure has the resonance of each level, shape (n,).
    frequency, dissipation, damping_ratio : ndarray
        Computed values at each level, Hz, J and 1, shape (n,).
    residual, frequency_residual : ndarray
        Residuals of loss and frequency over their scatter, 1, shape (n,).
    amplitude : ndarray
        Amplitude of each joint of the structure at each level, m, shape (n, joints).
    joint_dissipation : ndarray
        D of each joint with the ends of its band, J, shape (n, joints, 3): value, lower, upper.
    pairs : tuple of JointPair
        One for every two identified joints.
    frequency_offset : ndarray
        Offset of the frequencies of each mode, relative, 1; NaN for modes without.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        How the method ended.
    """

    joints: tuple[CalibratedJoint, ...]
    structure: Structure
    found: Any
    frequency: RealArray
    dissipation: RealArray
    damping_ratio: RealArray
    residual: RealArray
    frequency_residual: RealArray
    amplitude: RealArray
    joint_dissipation: RealArray
    pairs: tuple[JointPair, ...]
    frequency_offset: RealArray
    warnings: tuple[Note, ...]
    summary: Summary

    def __getitem__(self, name: str) -> CalibratedJoint:
        for joint in self.joints:
            if joint.name == name:
                return joint
        raise KeyError(f"{name!r}; must be one of {', '.join(joint.name for joint in self.joints)}")

    @property
    def draws(self) -> list[Optional[JointDraws]]:
        """Draws of each joint of the structure, for its predictions; None where it was given."""
        found = {joint.name: joint.draws for joint in self.joints}
        return [found.get(joint.name or "") for joint in self.structure.joints]

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with one row per level."""
        import pandas

        columns: dict[str, Any] = {
            "frequency [Hz]": self.frequency, "dissipation [J]": self.dissipation,
            "damping_ratio [1]": self.damping_ratio, "residual [1]": self.residual,
            "frequency_residual [1]": self.frequency_residual,
        }  # fmt: skip
        for j, joint in enumerate(self.structure.joints):
            columns[f"amplitude_{joint.name} [m]"] = self.amplitude[:, j]
            columns[f"dissipation_{joint.name} [J]"] = self.joint_dissipation[:, j, 0]
        return pandas.DataFrame(columns)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("levels", f"{int(self.found.sum())} of {len(self.found)} found")]
        for joint in self.joints:
            reduction = 100 * float(joint.variance_reduction.max())
            rows.append((f"joint {joint.name}", f"{si(joint.stiffness.value, 'N/m')}, variance"
                         f" reduction up to {reduction:.3g} %"))  # fmt: skip
        return "Calibration", rows + outcome(self)


def _paths(value: object, name: str) -> list[str]:
    if isinstance(value, (list, tuple)):
        if not value:
            raise InputError(f"{name} is empty; must have at least one path")
        return [path_of(one, f"{name}[{i}]") for i, one in enumerate(value)]
    return [path_of(value, name)]


def _is_path(value: object) -> bool:
    return isinstance(value, (str, bytes, os.PathLike))


def _all_paths(value: object) -> bool:
    many = value if isinstance(value, (list, tuple)) else [value]
    return bool(many) and all(_is_path(one) for one in many)


def calibrate(
    model: Union[Structure, Path],
    levels: Union[ModalLevels, Path, Sequence[Path]],
    *,
    find: Optional[Sequence[str]] = None,
    response: Optional[str] = None,
    frequency: str = "change",
    fit_stiffness: bool = False,
    shapes: str = "found",
    edges: bool = True,
    modal_forcing: bool = False,
    harmonics: int = 5,
    samples: int = 1000,
    seed: int = 1,
    out: Optional[Path] = None,
    keep_samples: bool = True,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> Calibration:
    """Identifies the densities of several joints of a structure at once from levels of its modes.

    Parameters
    ----------
    model : Structure or path
        Path of a model.toml, whose joints to be identified have ``stiffness_N_per_m`` in place of a
        file; or the structure, whose joints to be identified are springs of their k that do not
        slip.
    levels : ModalLevels, or path or sequence of path
        Levels, or paths of modal_levels.csv; four levels or more per joint.
    find : sequence of str, optional
        Names of the joints to be identified; by default those that the model.toml marks, or all
        joints of a structure.
    response : str, optional
        The point where displacements were measured; by default that of the model, or the first
        driven point.
    frequency : {"change", "absolute", "ignore"}
        What is used of frequencies: their change over the levels of each mode, their values, or
        nothing.
    fit_stiffness : bool
        Whether to identify k as well, which needs ``frequency="absolute"``.
    shapes : {"found", "stuck"}
        Displacements of the joints: of the structure with the identified joints, or for comparison
        of the stuck structure.
    edges : bool
        Whether to seek slip forces at which a density jumps.
    modal_forcing : bool
        Whether the levels were not driven, as in a free decay; else the excitation drove them at
        resonance.
    harmonics : int
        Number of harmonics of the vibrations; 1 to 100.
    samples : int
        Number of posterior draws; 100 to 100000.
    seed : int
        Seed of the draws.
    out : path, optional
        Folder for the files of ``microslip calibrate``: the joints, the model with them, tables;
        only where `model` and `levels` are paths.
    keep_samples : bool
        Whether to write the draws there as well.
    progress : callable, optional
        Called with (done, total); False cancels.
    strict : bool
        Whether to raise where the method does not converge; otherwise a warning is issued.

    Returns
    -------
    Calibration

    Raises
    ------
    ValueError
        Where a joint, level or argument breaks a rule; the message names it.
    NotConverged
        Where the method does not converge; holds the result up to there.
    """
    options = {
        "frequency": one_of(frequency, "frequency", ("change", "absolute", "ignore")),
        "fit_stiffness": flag(fit_stiffness, "fit_stiffness"),
        "stuck_shapes": one_of(shapes, "shapes", ("found", "stuck")) == "stuck",
        "edges": flag(edges, "edges"),
        "modal_forcing": flag(modal_forcing, "modal_forcing"),
        "harmonics": whole(harmonics, "harmonics", 1, 100),
        "samples": whole(samples, "samples", 100, 100_000),
        "seed": whole(seed, "seed", 0, 2**64 - 1),
    }
    keep_samples, strict = flag(keep_samples, "keep_samples"), flag(strict, "strict")
    structure, at, sought = _to_find(model)
    listener = progress_of(progress)
    if out is not None:
        for name, value in (("find", find), ("response", response)):
            if value is not None:
                raise InputError(f"{name} is given with out; must be in the model.toml")
        if not _is_path(model) or not _all_paths(levels):
            raise InputError("out is given with arrays; needs model and levels as paths")
        found = _core.calibrate_files(
            path_of(model, "model"), _paths(levels, "levels"), path_of(out, "out"),
            keep_samples, options, "microslip.calibrate", listener,
        )  # fmt: skip
    else:
        if find is not None:
            sought = _named(find, structure)
        at = at if response is None else text(response, "response")
        measured = levels if isinstance(levels, ModalLevels) else ModalLevels.read(levels, structure)
        found = _core.calibrate(structure._core, sought, at, measured._dict(), options,
                                "microslip.calibrate", listener)  # fmt: skip
    return reported(_calibration_of(found, structure), strict)


def _to_find(model: Any) -> tuple[Structure, str, list[int]]:
    if isinstance(model, Structure):
        return model, model._core.response, list(range(len(model.joints)))
    if not _is_path(model):
        raise InputError(f"model = {model!r}; must be a microslip.Structure or a path")
    core, response, sought = _core.read_model_to_find(path_of(model, "model"))
    return Structure._of(core), response, sought


def _named(find: object, structure: Structure) -> list[int]:
    names = [joint.name for joint in structure.joints]
    given = sequence(find, "find", "names")
    for i, name in enumerate(given):
        if name not in names:
            raise InputError(f"find[{i}] = {name!r}; must be one of {', '.join(map(str, names))}")
    if not given:
        raise InputError("find is empty; must name at least one joint")
    return sorted({names.index(name) for name in given})


def _joint_of(found: dict[str, Any]) -> CalibratedJoint:
    parts = dict(found)
    parts["joint"] = Joint._of(found["joint"])
    parts["stiffness"] = Estimate(*found["stiffness"])
    parts["elastic_stiffness"] = Estimate(*found["elastic_stiffness"])
    parts["edges"] = tuple(Edge(*edge) for edge in found["edges"])
    parts["draws"] = JointDraws._of(found["draws"])
    return CalibratedJoint(**parts)


def _calibration_of(found: dict[str, Any], structure: Structure) -> Calibration:
    joints = tuple(_joint_of(joint) for joint in found["joints"])
    by_name = {joint.name: joint for joint in joints}
    placed = [by_name.get(joint.name or "", joint) for joint in structure.joints]
    levels = found["levels"]

    def column(name: str) -> RealArray:
        return np.array([level[name] for level in levels], dtype=float)

    return Calibration(
        joints=joints,
        structure=structure.with_joints(placed),
        found=np.array([level["found"] for level in levels], dtype=bool),
        frequency=column("frequency"),
        dissipation=column("dissipation"),
        damping_ratio=column("damping_ratio"),
        residual=column("residual"),
        frequency_residual=column("frequency_residual"),
        amplitude=np.array([[joint[0] for joint in level["joints"]] for level in levels]),
        joint_dissipation=np.array([[joint[2] for joint in level["joints"]] for level in levels]),
        pairs=tuple(JointPair(*pair) for pair in found["pairs"]),
        frequency_offset=found["frequency_offset"],
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
    )
