# SPDX-License-Identifier: MIT
"""Time marching of posterior draws."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from . import _core
from ._arguments import ArrayLike, Progress, RealArray, flag, shown, text
from ._arguments import progress as progress_of
from ._errors import InputError
from ._march import MarchEnergy, march_arguments
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of
from ._spread import DrawsOrCount, Spread, drawn, is_number
from ._structure import Structure

if TYPE_CHECKING:
    import pandas


class Statistic(NamedTuple):
    """A statistic of a signal, with its band over the draws."""

    value: float
    lower: float
    upper: float


@dataclass(frozen=True, eq=False)
class MarchedSignal:
    """A signal of a march, one value per recorded time.

    Attributes
    ----------
    unit : str
        Unit of its values.
    values, lower, upper : ndarray
        Values of the structure itself, and the band of the draws, shape (n,).
    peak, rms : Statistic
        Largest absolute value and root of the mean square over all steps.
    """

    unit: str
    values: RealArray
    lower: RealArray
    upper: RealArray
    peak: Statistic
    rms: Statistic


@dataclass(frozen=True, repr=False, eq=False)
class MarchBand(Shown):
    """Result of `march_band`: the motion of a structure with bands over its draws.

    Attributes
    ----------
    time : ndarray
        Recorded times, s, shape (n,).
    signals : dict of str to MarchedSignal
        ``"displacement"``, ``"velocity"``, ``"acceleration"`` of the point, ``"lap displacement"``
        and ``"lap force"`` of each joint.
    failures : tuple of (str, int)
        Reasons why draws failed, and how many; these are in no band.
    error_estimate : float or None
        As of `MarchResult`.
    energy : MarchEnergy
        Energy balance of the structure itself.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        How the march of the structure itself ended. Bands are empty where it did not converge.
    """

    time: RealArray
    signals: dict[str, MarchedSignal]
    failures: tuple[tuple[str, int], ...]
    error_estimate: Optional[float]
    energy: MarchEnergy
    warnings: tuple[Note, ...]
    summary: Summary

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with three columns per signal."""
        import pandas

        columns = {"time [s]": self.time}
        for name, signal in self.signals.items():
            columns[f"{name} [{signal.unit}]"] = signal.values
            if len(signal.lower):
                columns[f"{name}_lower [{signal.unit}]"] = signal.lower
                columns[f"{name}_upper [{signal.unit}]"] = signal.upper
        return pandas.DataFrame(columns)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("recorded", f"{len(self.time)} times")]
        for name, signal in self.signals.items():
            of = signal.peak
            rows.append((f"peak {name}", f"{si(of.value, signal.unit)}, {of.lower:.5g} to"
                         f" {of.upper:.5g}"))  # fmt: skip
        return "March with draws", rows + outcome(self)


def march_band(
    structure: Structure,
    time: ArrayLike,
    forces: Optional[Mapping[str, ArrayLike]] = None,
    *,
    point: Optional[str] = None,
    draws: Optional[DrawsOrCount] = None,
    samples: Optional[DrawsOrCount] = None,
    seed: int = 1,
    confidence: float = 0.95,
    correlation: str = "auto",
    spread: Optional[Spread] = None,
    progress: Optional[Progress] = None,
    strict: bool = True,
    **options: Any,
) -> MarchBand:
    """Marches a structure in time, then each of its draws.

    Parameters
    ----------
    structure, time, forces
        As of `march`.
    point : str, optional
        Point whose motion is recorded; by default that of `HarmonicBalance`.
    draws, samples, seed, confidence, correlation, spread
        As of `HarmonicBalance.frequency_response`; `samples` is the number of draws, 1000 where
        neither says it.
    progress : callable, optional
        Called with (done, total) of the times, then of the draws; False cancels.
    strict : bool
        Whether to raise where the march does not converge; otherwise a warning is issued.
    **options
        Those of `march` except `points`.

    Returns
    -------
    MarchBand

    Raises
    ------
    ValueError, NotConverged
    """
    strict = flag(strict, "strict")
    if not isinstance(structure, Structure):
        raise InputError(f"structure = {shown(structure)}; must be a microslip.Structure")
    if "points" in options:
        raise InputError("points is given; must be point, a single name")
    at = structure._core.response if point is None else text(point, "point")
    acting = march_arguments(structure, time, forces, points=[at], **options)
    if samples is None:
        samples = 0 if is_number(draws) else 1000
    asked = drawn(structure, draws, samples, seed, confidence, correlation, spread)
    if asked is None:
        raise InputError("samples = 0; must be positive. Use march without draws.")
    found = _core.draw_march(structure._core, at, *acting, asked, progress_of(progress))
    signals = {
        name: MarchedSignal(unit, values, lower, upper, Statistic(*peak), Statistic(*rms))
        for name, unit, values, lower, upper, peak, rms in found["signals"]
    }
    result = MarchBand(
        time=found["time"],
        signals=signals,
        failures=tuple(found["failures"]),
        error_estimate=found["error_estimate"],
        energy=MarchEnergy(**found["energy"]),
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
    )
    return reported(result, strict)
