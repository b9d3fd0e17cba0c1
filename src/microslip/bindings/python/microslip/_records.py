# SPDX-License-Identifier: MIT
"""Identifies a joint and its stiffness from its force-displacement records."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    Progress,
    RealArray,
    flag,
    one_of,
    positive,
    real_array,
    sequence,
    text,
    whole,
)
from ._arguments import progress as progress_of
from ._errors import InputError
from ._identification import Identification, Verdict, _identification_of
from ._levels import Levels
from ._recordings import Recording, recordings_of
from ._results import reported, si


class Estimate(NamedTuple):
    """A number with its band."""

    value: float
    lower: float
    upper: float


@dataclass(frozen=True)
class RecordFit:
    """Fit of one record.

    Attributes
    ----------
    source : str
        Source of the record.
    start : str
        The assumed initial state: ``"virgin"`` or ``"unknown"``.
    start_shown : bool
        Whether the first samples show that state.
    offset : ndarray
        F0 of each group of rows, N.
    displacement_drift, force_drift : ndarray
        Drift that was subtracted with ``drift=True``, m and N: coefficients of t/T, (t/T)^2, ... with
        the time t from the first sample and the length T of the record. Empty where none was found.
    residual : ndarray
        Measured minus fitted force of each row, N.
    scatter : float
        Standard deviation of the force of one sample, N.
    correlation : float
        Correlation of the residuals of neighbouring rows, 1.
    unexplained : float
        rms of residuals over that of the force, 1.
    verdicts : tuple of Verdict
        Checks for departures from the model of the joint, the most serious first.
    """

    source: str
    start: str
    start_shown: bool
    offset: RealArray
    displacement_drift: RealArray
    force_drift: RealArray
    residual: RealArray
    scatter: float
    correlation: float
    unexplained: float
    verdicts: tuple[Verdict, ...]


@dataclass(frozen=True, repr=False, eq=False)
class RecordIdentification(Identification):
    """A joint identified from records, with its diagnostics: an `Identification` with

    Attributes
    ----------
    stiffness : Estimate
        k with its band, N/m; a given k is returned as it is.
    elastic_stiffness : Estimate
        Stiffness that does not slip within the records, N/m.
    viscous : Estimate or None
        c of a viscous part, N s/m; None where it was not identified.
    resolved_from : float
        Smallest slip displacement that the records resolve, m.
    records : tuple of RecordFit
        Fit of each record.
    """

    stiffness: Estimate
    elastic_stiffness: Estimate
    viscous: Optional[Estimate]
    resolved_from: float
    records: tuple[RecordFit, ...]

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        title, rows = super()._facts()
        k = self.stiffness
        rows[1] = ("stiffness", f"{si(k.value, 'N/m')}, {k.lower:.5g} to {k.upper:.5g}")
        if self.viscous is not None:
            rows.insert(2, ("viscous", si(self.viscous.value, "N s/m")))
        fits = [(f"record {fit.source}", f"{100 * fit.unexplained:.2g} % of the force unexplained")
                for fit in self.records]  # fmt: skip
        return title, rows[:-1] + fits + rows[-1:] if fits else rows


#: A record as the compiled half takes it: name, displacement, force, time step.
_Record = tuple[str, RealArray, RealArray, float]


def _arrays(value: Any, name: str) -> list[RealArray]:
    """One array, or several of different lengths."""
    if isinstance(value, (list, tuple)) and value and not np.isscalar(value[0]):
        return [real_array(one, f"{name}[{i}]") for i, one in enumerate(value)]
    return [real_array(value, name)]


def _of_arrays(force: Any, displacement: Any, time_step: Any, fs: Any) -> list[_Record]:
    if displacement is None:
        raise InputError("displacement is missing; must be an array, as force is")
    if time_step is not None and fs is not None:
        raise InputError("time_step and fs are both given; must be one of them")
    step = 0.0
    if time_step is not None:
        step = positive(time_step, "time_step")
    elif fs is not None:
        step = 1.0 / positive(fs, "fs")
    forces, displacements = _arrays(force, "force"), _arrays(displacement, "displacement")
    if len(forces) != len(displacements):
        raise InputError(f"displacement has {len(displacements)} records; must have {len(forces)},"
                         " those of force")  # fmt: skip
    for i, (f, u) in enumerate(zip(forces, displacements)):
        at = f"[{i}]" if len(forces) > 1 else ""
        if len(f) != len(u):
            raise InputError(f"displacement{at} has {len(u)} numbers; must have {len(f)}, one a"
                             " force")  # fmt: skip
    names = ["arrays"] if len(forces) == 1 else [f"arrays {i + 1}" for i in range(len(forces))]
    return [(name, u, f, step) for name, f, u in zip(names, forces, displacements)]


def _of_recordings(records: Any, force: Any, displacement: Any, time_step: Any,
                   fs: Any) -> list[_Record]:  # fmt: skip
    for name, value in (("time_step", time_step), ("fs", fs)):
        if value is not None:
            raise InputError(f"{name} is given beside recordings, which have their own")
    chosen = ["" if name is None else text(name, what)
              for what, name in (("force", force), ("displacement", displacement))]  # fmt: skip
    return [(r.source, *_core.force_record(r._dict(), chosen[0], chosen[1]))
            for r in recordings_of(records, "records")]  # fmt: skip


def _tables(levels: Any) -> list[tuple[str, dict[str, Optional[RealArray]]]]:
    if levels is None:
        return []
    if isinstance(levels, Levels) or hasattr(levels, "keys"):
        return [("levels", Levels.of(levels)._columns())]
    given = sequence(levels, "levels", "Levels")
    return [(f"levels {i + 1}", Levels.of(one)._columns()) for i, one in enumerate(given)]


def identify_records(
    records: Union[None, Recording, Sequence[Recording]] = None,
    *,
    force: Union[None, str, ArrayLike, Sequence[ArrayLike]] = None,
    displacement: Union[None, str, ArrayLike, Sequence[ArrayLike]] = None,
    time_step: Optional[float] = None,
    fs: Optional[float] = None,
    levels: Union[None, Levels, Sequence[Levels]] = None,
    stiffness: Optional[float] = None,
    viscous: bool = False,
    drift: bool = False,
    start: str = "auto",
    samples: int = 1000,
    seed: int = 1,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> RecordIdentification:
    """Identifies the joint whose force along displacement paths was recorded.

    Parameters
    ----------
    records : Recording or sequence of Recording, optional
        Records of one joint, evenly sampled. Without them `force` and `displacement` are arrays.
    force, displacement : str or array_like or list of array_like
        Names of the channels of recordings, not needed where there is one force and one
        displacement; or the arrays, N and m, shape (n,), several records as lists of arrays.
        Positive work is done on the joint: the force has the sign of a spring's.
    time_step : float, optional
        Time step of arrays, s; or
    fs : float, optional
        their sampling rate, Hz. Needed only for a viscous part and for smoothing of the path.
    levels : Levels or sequence of Levels, optional
        Levels of the same joint, as tables each with their own errors.
    stiffness : float, optional
        k of the stuck joint, N/m; identified by default.
    viscous : bool
        Whether to identify a viscous part in addition to the friction.
    drift : bool
        Whether to find slow drifts of the zeros of both sensors with the joint and subtract them.
    start : {"auto", "virgin", "unknown"}
        Initial state of the records; detected with ``"auto"``.
    samples : int
        Number of posterior draws; 100 or more.
    seed : int
        Seed of the draws.
    progress : callable, optional
        Called with (done, total) of the draws; False cancels.
    strict : bool
        Whether to raise where the method does not converge; otherwise a warning is issued.

    Returns
    -------
    RecordIdentification

    Raises
    ------
    ValueError
        Where a record or an argument breaks a rule, for instance a path without reversals or work
        of the wrong sign; the message names it.
    NotConverged
        Where the method does not converge; holds the result up to there.

    Examples
    --------
    >>> import microslip, numpy as np
    >>> truth = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> t = np.arange(4000) / 1000
    >>> u = 8e-5 * np.sin(2 * np.pi * t) * t / 4
    >>> found = microslip.identify_records(
    ...     force=microslip.Memory(truth).march(u), displacement=u, fs=1000, samples=100)
    >>> bool(abs(found.stiffness.value / 1e5 - 1) < 0.02)
    True
    """
    strict = flag(strict, "strict")
    if records is not None:
        given = _of_recordings(records, force, displacement, time_step, fs)
    elif force is None:
        raise InputError("force is missing; must be an array, or records must be given")
    elif isinstance(force, str) or isinstance(displacement, str):
        raise InputError("force and displacement are names of channels; must be arrays where no"
                         " records are given")  # fmt: skip
    else:
        given = _of_arrays(force, displacement, time_step, fs)
    options = {
        "stiffness": None if stiffness is None else positive(stiffness, "stiffness"),
        "viscous": flag(viscous, "viscous"),
        "drift": flag(drift, "drift"),
        "start": one_of(start, "start", ("auto", "virgin", "unknown")),
        "samples": whole(samples, "samples", 100, 1_000_000),
        "seed": whole(seed, "seed", 0, 2**64 - 1),
    }
    found = _core.identify_records(
        given, _tables(levels), options, "microslip.identify_records", progress_of(progress)
    )
    return reported(_found(found), strict)


def _found(found: dict[str, Any]) -> RecordIdentification:
    fits = []
    for fit in found["records"]:
        verdicts = tuple(Verdict(*numbers) for numbers in fit.pop("verdicts"))
        fits.append(RecordFit(**fit, verdicts=verdicts))
    viscous = found["viscous"]
    return RecordIdentification(
        **vars(_identification_of(found)),
        stiffness=Estimate(*found["stiffness"]),
        elastic_stiffness=Estimate(*found["elastic_stiffness"]),
        viscous=None if viscous is None else Estimate(*viscous),
        resolved_from=found["resolved_from"],
        records=tuple(fits),
    )
