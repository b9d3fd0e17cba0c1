# SPDX-License-Identifier: MIT
"""Tests of a frictional support: virtual ones, records to levels, records against a joint."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _core
from ._core import Rig as CoreRig
from ._arguments import (
    Path,
    Progress,
    RealArray,
    flag,
    not_negative,
    one_of,
    positive,
    real,
    text,
    whole,
)
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._draws import JointDraws
from ._errors import InputError
from ._joint import AnyJoint, IdentifiedJoint, Joint, identified
from ._levels import Levels
from ._recordings import Recording, recordings_of
from ._results import Note, Shown, Summary, fix, notes, outcome, reported, si, summary_of, warn_of
from ._spread import draws_and_count
from ._structure import Structure

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

#: Columns of a table as in its file: ``"amplitude [m]"`` to an array, texts to a list.
Table = Mapping[str, Union[RealArray, list[str]]]


class Rig(Shown):
    """The description of a frictional-support test: a beam or modes, the contact, sensors, and for
    a virtual test the levels to be measured. Immutable. See docs/file_formats.md, rig.toml.

    Examples
    --------
    >>> import microslip
    >>> rig = microslip.Rig.read("rig.toml")  # doctest: +SKIP
    >>> levels = microslip.reduce(rig, microslip.read_recordings("level_01.csv"))  # doctest: +SKIP
    """

    __slots__ = ("_core", "_path")
    _core: CoreRig
    _path: Optional[str]

    def __init__(self) -> None:
        raise TypeError("a Rig comes from Rig.read, or from a text by Rig.parse")

    @classmethod
    def _of(cls, core: CoreRig, path: Optional[str] = None) -> Rig:
        rig = object.__new__(cls)
        rig._core = core
        rig._path = path
        return rig

    @classmethod
    def read(cls, path: Path) -> Rig:
        """Reads a rig.toml.

        Raises
        ------
        FileError, FormatError, ValueError
            Where a key breaks a rule; the message names it.
        """
        name = path_of(path, "path")
        return cls._of(_core.read_rig(name), name)

    @classmethod
    def parse(cls, toml: str, name: str = "rig.toml") -> Rig:
        """Parses the text of a rig.toml; `name` is for messages."""
        return cls._of(_core.parse_rig(text(toml, "toml"), text(name, "name")))

    def write(self, path: Path) -> None:
        """Writes a rig.toml: at once and whole, or not at all."""
        heading = "# microslip "
        text = self.text
        if not text.startswith(heading):  # by which the file shows that it may be replaced
            text = f"{heading}{_core.version}: microslip.Rig.write\n{text}"
        _core.write_file(path_of(path, "path"), text.encode())

    @property
    def text(self) -> str:
        """The name given in the rig.toml."""
        return self._core.text()

    @property
    def stiffness(self) -> float:
        """k of the stuck joint, N/m; 0 where it is not known."""
        return self._core.stiffness

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the channels of its recordings: force, accelerometers, vibrometer."""
        return tuple(self._core.channels)

    def stuck_frequencies(self) -> RealArray:
        """Natural frequencies with the joint stuck, Hz."""
        return self._core.stuck_frequencies() / (2.0 * np.pi)

    def structure(self, joint: AnyJoint, *, linear_damping: Optional[float] = None) -> Structure:
        """The structure of the test with a joint in its contact, driven at the exciter; its points
        have the names of the channels there. `linear_damping`, J/m**2, is by default that of an
        identification."""
        known = identified(joint, "joint")
        damping = known.linear_damping or 0.0
        if linear_damping is not None:
            damping = not_negative(linear_damping, "linear_damping")
        return Structure._of(_core.rig_structure(self._core, known.joint._core, damping))

    def true_joint(self) -> tuple[Joint, float]:
        """The joint that the rig names for a virtual test, and its linear damping, J/m**2.

        Raises
        ------
        ValueError
            Where the rig names no joint, or was not read from a file, to which the name is
            relative.
        """
        if not self._core.joint:
            raise InputError("contact.joint is missing; must name the file of the true joint, or"
                             " joint must be given")  # fmt: skip
        if self._path is None:
            raise InputError("the rig is of no file, to which its joint is relative; give joint")
        at = os.path.join(os.path.dirname(self._path), self._core.joint)
        core, damping, _ = _core.read_joint(at)
        return Joint._of(core), damping or 0.0

    def __reduce__(self) -> tuple[Any, ...]:
        return _rig_of, (self.text, self._path)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        stuck = self.stuck_frequencies()
        shown = ", ".join(f"{f:.5g}" for f in stuck[:5]) + (", ..." if len(stuck) > 5 else "")
        return "Rig", [
            ("channels", ", ".join(self.channels)),
            ("stuck joint", si(self.stiffness, "N/m")),
            ("stuck frequencies", f"{shown} Hz"),
            ("virtual test", "yes" if self._core.has_test else "no"),
        ]


def _rig_of(toml: str, path: Optional[str]) -> Rig:
    return Rig._of(_core.parse_rig(toml, path or "rig.toml"), path)


def _rig(rig: object) -> Rig:
    if not isinstance(rig, Rig):
        raise InputError(f"rig = {rig!r}; must be a microslip.Rig")
    return rig


def frame_of(table: Table) -> pandas.DataFrame:
    import pandas

    return pandas.DataFrame(dict(table))


@dataclass(frozen=True, repr=False, eq=False)
class Measurement(Shown):
    """Result of `measure`: the recordings of a virtual test.

    Attributes
    ----------
    recordings : tuple of Recording
        One per level that was found, ``level_01``, ``level_02``, ...
    before_control : tuple of Recording
        The levels under a sinusoidal voltage, where requested.
    truth : mapping of str to ndarray
        The exact levels, which a reduction should find: the columns of truth.csv.
    force_control : mapping of str to ndarray
        History of the control of the force: the columns of force_control.csv; empty without shaker.
    warnings : tuple of Note
        Warnings, each kind once.
    summary : Summary
        How the levels were computed.
    """

    recordings: tuple[Recording, ...]
    before_control: tuple[Recording, ...]
    truth: Table
    force_control: Table
    warnings: tuple[Note, ...]
    summary: Summary
    _truth_csv: str

    @property
    def levels(self) -> Levels:
        """The truth as levels, for `identify`."""
        return Levels(**_core.parse_levels(self._truth_csv))

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame of the truth."""
        return frame_of(self.truth)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("levels", str(len(self.recordings)))]
        if self.recordings:
            rows.append(("points", f"{len(self.recordings[0])} a record"))
        return "Virtual test", rows + outcome(self)


def measure(
    rig: Rig,
    joint: Optional[AnyJoint] = None,
    *,
    seed: int = 1,
    shaker: bool = True,
    before_control: bool = False,
    force_distortion: float = 0.003,
    linear_damping: Optional[float] = None,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> Measurement:
    """Runs a virtual test: computes the recordings of a rig with a known joint.

    Parameters
    ----------
    rig : Rig
        With ``[test]``.
    joint : Joint, IdentifiedJoint or Identification, optional
        The true joint; by default that of the rig's file.
    seed : int
        Seed of noise and phases.
    shaker : bool
        Whether a shaker with a controlled force drives the rig; otherwise a pure force.
    before_control : bool
        Whether to record the levels under a sinusoidal voltage as well.
    force_distortion : float
        Ratio of the harmonics of the force to the first at which the control stops, 1; above 0.
    linear_damping : float, optional
        beta of the joint, J/m**2, in place of the identified one.
    progress : callable, optional
        Called with (levels done, levels); False cancels.
    strict : bool
        Whether to raise where a level is not found; otherwise a warning is issued.

    Returns
    -------
    Measurement

    Raises
    ------
    ValueError, NotConverged
    """
    strict = flag(strict, "strict")
    _rig(rig)
    true = IdentifiedJoint(*rig.true_joint()) if joint is None else identified(joint, "joint")
    damping = true.linear_damping or 0.0
    if linear_damping is not None:
        damping = not_negative(linear_damping, "linear_damping")
    options = {
        "seed": whole(seed, "seed", 0, 2**64 - 1),
        "shaker": flag(shaker, "shaker"),
        "before_control": flag(before_control, "before_control"),
        "force_distortion": positive(force_distortion, "force_distortion"),
        "linear_damping": damping,
    }
    if before_control and not shaker:
        raise InputError("before_control is given without shaker; must be False")
    found = _core.measure(rig._core, true.joint._core, options, progress_of(progress))
    result = Measurement(
        recordings=tuple(Recording._of(recording) for recording in found["recordings"]),
        before_control=tuple(Recording._of(recording) for recording in found["before_control"]),
        truth=found["truth"],
        force_control=found["force_control"],
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
        _truth_csv=found["truth_csv"],
    )
    return reported(result, strict)


@dataclass(frozen=True, repr=False, eq=False)
class Reduction(Shown):
    """Levels of a test, reduced from its records.

    Attributes
    ----------
    table : mapping of str to ndarray or list of str
        The columns of levels.csv, ``"amplitude [m]"``, ..., ``"flags"``: of the levels with a
        dissipation of 0 or more, in the order of the records.
    flags : tuple of str
        Flags of each level, separated by blanks; docs/file_formats.md explains them under
        levels.csv.
    rejected : tuple of (int, str)
        With `skip_faulty`: which records were left out, from 0, and why.
    warnings : tuple of Note
        Warnings that concern the result.
    """

    table: Table
    flags: tuple[str, ...]
    rejected: tuple[tuple[int, str], ...]
    warnings: tuple[Note, ...]
    _csv: str

    @property
    def levels(self) -> Levels:
        """Levels for `identify`, with resonance frequencies; levels with more than two reversals
        per cycle, whose D is not that of one loop, are left out."""
        return Levels(**_core.parse_levels(self._csv))

    def write(self, path: Path) -> None:
        """Writes a levels.csv: at once and whole, or not at all."""
        _core.write_file(path_of(path, "path"), self._csv.encode())

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of levels.csv."""
        return frame_of(self.table)

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws D over A, by matplotlib."""
        return self.levels.plot(ax, **style)

    def __len__(self) -> int:
        return len(self.flags)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = self.levels._facts()[1]
        if self.rejected:
            rows.append(("left out", f"{len(self.rejected)} records"))
        rows.extend(("warning", str(note)) for note in self.warnings)
        return "Reduction", rows


def _reduction_options(frequency: Optional[float], order: object, modes: object,
                       use_vibrometer: object, name: str = "order") -> dict[str, Any]:  # fmt: skip
    return {
        "frequency": None if frequency is None else positive(frequency, "frequency"),
        "order": whole(order, name, 1, 100),
        "modes": whole(modes, "modes", 0, 200),
        "use_vibrometer": flag(use_vibrometer, "use_vibrometer"),
    }


def reduce(
    rig: Rig,
    recordings: Union[Recording, Sequence[Recording]],
    *,
    frequency: Optional[float] = None,
    order: int = 10,
    modes: int = 0,
    use_vibrometer: bool = True,
    skip_faulty: bool = False,
    progress: Optional[Progress] = None,
) -> Reduction:
    """Reduces steady records of a frictional-support test to levels.

    Parameters
    ----------
    rig : Rig
        The rig that was recorded.
    recordings : Recording or sequence of Recording
        One per level, with the channels that the rig names.
    frequency : float, optional
        Drive frequency, to 3 %, Hz; by default found from the records.
    order : int
        Number of fitted harmonics; 1 to 100.
    modes : int
        Number of modes of the beam, 1 to 200; 0: those of the rig's test, or 30.
    use_vibrometer : bool
        Whether the joint displacement is taken from the vibrometer, where there is one.
    skip_faulty : bool
        Whether to leave out records that cannot be reduced.
    progress : callable, optional
        Called with (records done, records); False cancels.

    Returns
    -------
    Reduction

    Raises
    ------
    ValueError
        Where a channel is missing, has another unit or no steady vibration; the message names
        record and channel.
    """
    _rig(rig)
    given = [recording._dict() for recording in recordings_of(recordings)]
    options = _reduction_options(frequency, order, modes, use_vibrometer)
    found = _core.reduce(rig._core, given, options, flag(skip_faulty, "skip_faulty"),
                         "microslip.reduce", progress_of(progress))  # fmt: skip
    warn_of(found["warnings"])
    result = Reduction(
        table=found["table"],
        flags=tuple(found["table"]["flags"]),
        rejected=tuple(found["rejected"]),
        warnings=notes(found["warnings"]),
        _csv=found["csv"],
    )
    fix(result)
    return result


@dataclass(frozen=True, repr=False, eq=False)
class Verification(Shown):
    """Comparison of predictions with records, one row per record and channel.

    Attributes
    ----------
    table : mapping of str to ndarray or list of str
        The columns of verification.csv: ``"source"``, ``"channel"``, ``"status"``,
        ``"NRMSE [1]"``, ``"noise_share [1]"``, ``"amplitude_ratio [1]"``,
        ``"phase_error [rad]"``, ...; with draws also their bands.
    harmonics : mapping of str to ndarray or list of str
        Recorded and predicted harmonics of each record.
    histories : mapping of str to ndarray or list of str
        A few cycles of each record.
    rejected : tuple of (int, str)
        With `skip_faulty`: which records were left out, from 0, and why.
    failed_draws : int or None
        Number of draws that failed and are in no band; None without draws.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        That of the first record whose prediction did not converge, or of the first record.
    """

    table: Table
    harmonics: Table
    histories: Table
    rejected: tuple[tuple[int, str], ...]
    failed_draws: Optional[int]
    warnings: tuple[Note, ...]
    summary: Summary
    _csv: str

    def nrmse(self, channel: str) -> RealArray:
        """rms(recorded - predicted)/rms(recorded) of a channel, 1, shape (records,)."""
        names: npt.NDArray[Any] = np.array(self.table["channel"])
        one_of(channel, "channel", tuple(dict.fromkeys(names.tolist())))
        values: RealArray = np.asarray(self.table["NRMSE [1]"])[names == channel]
        return values

    def write(self, path: Path) -> None:
        """Writes a verification.csv: at once and whole, or not at all."""
        _core.write_file(path_of(path, "path"), self._csv.encode())

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of verification.csv."""
        return frame_of(self.table)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        names = dict.fromkeys(self.table["channel"])
        rows = [("records", str(len(self.table["channel"]) // max(len(names), 1)))]
        for name in names:
            worst = 100.0 * float(self.nrmse(str(name)).max())
            rows.append((str(name), f"NRMSE up to {worst:.3g} %"))
        if self.failed_draws is not None:
            rows.append(("failed draws", str(self.failed_draws)))
        return "Verification", rows + outcome(self)


def _known_joint(joint: Any) -> IdentifiedJoint:
    """A joint, an identification or the joint of a path as an `IdentifiedJoint`."""
    if isinstance(joint, (str, bytes, os.PathLike)):
        return IdentifiedJoint.read(os.fsdecode(joint))
    return identified(joint, "joint")


def _spread_of_rig(count: int, spread: dict[str, float]) -> dict[str, float]:
    """Standard deviations of the rig, checked; empty without draws, which alone use them."""
    checked = {name: not_negative(value, name) for name, value in spread.items()}
    for name, value in checked.items():
        if count == 0 and value > 0.0:
            raise InputError(f"samples is 0; must be the number of draws, as {name} is"
                             " given")  # fmt: skip
    return checked


def verify(
    rig: Rig,
    joint: Union[AnyJoint, Path],
    recordings: Union[Recording, Sequence[Recording]],
    *,
    frequency: Optional[float] = None,
    harmonics: int = 10,
    modes: int = 7,
    sine: bool = False,
    cycles: float = 2.0,
    use_vibrometer: bool = True,
    skip_faulty: bool = False,
    linear_damping: Optional[float] = None,
    draws: Optional[Union[JointDraws, int]] = None,
    samples: Union[int, JointDraws] = 0,
    seed: int = 1,
    confidence: float = 0.95,
    frequency_std: float = 0.0,
    loss_factor_std: float = 0.0,
    normal_load_std: float = 0.0,
    force_gain_std: float = 0.0,
    acceleration_gain_std: float = 0.0,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> Verification:
    """Compares records of a test with the predictions of a joint.

    Parameters
    ----------
    rig : Rig
        The rig that was recorded.
    joint : Joint, IdentifiedJoint, Identification or path
        The joint to be verified; an identification or a joint.json also gives its linear damping
        and the slip force up to which it was measured.
    recordings : Recording or sequence of Recording
        Steady records, with the channels that the rig names.
    frequency : float, optional
        Drive frequency, to 3 %, Hz; by default found from the records.
    harmonics : int
        Number of harmonics that are fitted and compared; 1 to 100.
    modes : int
        Number of modes of the beam in the model; 1 to 200.
    sine : bool
        Whether only the first harmonic of the force drives the model.
    cycles : float
        Number of cycles that are kept as histories; 0 or more.
    use_vibrometer, skip_faulty
        As of `reduce`.
    linear_damping : float, optional
        beta of the joint, J/m**2, in place of the identified one.
    draws : JointDraws, optional
        Posterior draws of the joint, for bands of the prediction.
    samples : int
        Number of draws that are predicted; 0: none, else 2/(1 - confidence) or more. As with the
        options of the program, the two may also be the other way round.
    seed, confidence
        Seed of the draws; share of them in a band, in (0, 1).
    frequency_std, loss_factor_std, normal_load_std, force_gain_std, acceleration_gain_std : float
        Relative standard deviations of the rig, 1, drawn with the joint.
    progress : callable, optional
        Called with (done, total) of records, then of draws; False cancels.
    strict : bool
        Whether to raise where a prediction does not converge; otherwise a warning is issued.

    Returns
    -------
    Verification

    Raises
    ------
    ValueError, NotConverged
    """
    strict = flag(strict, "strict")
    _rig(rig)
    known = _known_joint(joint)
    damping = known.linear_damping or 0.0
    if linear_damping is not None:
        damping = not_negative(linear_damping, "linear_damping")
    given = [recording._dict() for recording in recordings_of(recordings)]
    options = _reduction_options(frequency, harmonics, modes, use_vibrometer, "harmonics") | {
        "sine": flag(sine, "sine"),
        "cycles": not_negative(cycles, "cycles"),
        "covered_to": known.covered_to,
        "linear_damping": damping,
    }
    asked = None
    draws, count = draws_and_count(draws, samples)
    if draws is not None and not isinstance(draws, JointDraws):
        raise InputError(f"draws = {draws!r}; must be microslip.JointDraws")
    if draws is not None and not count:
        raise InputError("samples is 0; must be the number of draws to predict")
    spread = _spread_of_rig(count, {
        "frequency_std": frequency_std, "loss_factor_std": loss_factor_std,
        "normal_load_std": normal_load_std, "force_gain_std": force_gain_std,
        "acceleration_gain_std": acceleration_gain_std,
    })  # fmt: skip
    if count:
        asked = {
            "count": count,
            "confidence": real(confidence, "confidence"),
            "seed": whole(seed, "seed", 0, 2**64 - 1),
            "joint": None if draws is None else draws._core,
            **spread,
        }
    found = _core.verify(rig._core, known.joint._core, given, options, flag(skip_faulty, "skip_faulty"), asked,
                         "microslip.verify", progress_of(progress))  # fmt: skip
    result = Verification(
        table=found["table"],
        harmonics=found["harmonics"],
        histories=found["histories"],
        rejected=tuple(found["rejected"]),
        failed_draws=found["failed_draws"],
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
        _csv=found["csv"],
    )
    return reported(result, strict)
