# SPDX-License-Identifier: MIT
"""From force-displacement records of a joint to the joint, its stiffness with it."""

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
from ._results import si, told


class Estimate(NamedTuple):
    """A number with its band."""

    value: float
    lower: float
    upper: float


@dataclass(frozen=True)
class RecordFit:
    """What came of one record.

    Attributes
    ----------
    source : str
        Of the record.
    start : str
        The state that it was taken to begin in: ``"virgin"`` or ``"unknown"``.
    start_shown : bool
        Whether its first samples show that.
    offset : ndarray
        F0 of each group of rows, N.
    residual : ndarray
        Measured less found force of each row, N.
    scatter : float
        Of the force of one sample, N.
    correlation : float
        Of the residuals of neighbouring rows, 1.
    unexplained : float
        rms of residuals over that of the force, 1.
    verdicts : tuple of Verdict
        Of each departure from such a joint that was looked for, the weightiest first.
    """

    source: str
    start: str
    start_shown: bool
    offset: RealArray
    residual: RealArray
    scatter: float
    correlation: float
    unexplained: float
    verdicts: tuple[Verdict, ...]


@dataclass(frozen=True, repr=False, eq=False)
class RecordIdentification(Identification):
    """A joint from records, and what its user must know of it: an `Identification` with

    Attributes
    ----------
    stiffness : Estimate
        k with its band, N/m; of a k that was given it is that.
    elastic_stiffness : Estimate
        What does not slip within the records, N/m.
    viscous : Estimate or None
        c of a viscous part, N s/m; None where it was not sought.
    resolved_from : float
        Smallest slip displacement that the records tell, m.
    records : tuple of RecordFit
        What came of each.
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


#: As the package hands a record over: name, displacement, force, time step.
_Record = tuple[str, RealArray, RealArray, float]


def _arrays(value: Any, name: str) -> list[RealArray]:
    """One array, or several of different lengths."""
    if isinstance(value, (list, tuple)) and value and not np.isscalar(value[0]):
        return [real_array(one, f"{name}[{i}]") for i, one in enumerate(value)]
    return [real_array(value, name)]


def _of_arrays(force: Any, displacement: Any, time_step: Any, fs: Any) -> list[_Record]:
    if displacement is None:
        raise InputError("displacement is missing; must be an array, beside force")
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
    start: str = "auto",
    samples: int = 1000,
    seed: int = 1,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> RecordIdentification:
    """The joint that answers paths with the forces that were recorded.

    Parameters
    ----------
    records : Recording or sequence of Recording, optional
        Of one joint, evenly sampled. Without them `force` and `displacement` are arrays.
    force, displacement : str or array_like or list of array_like
        Names of the channels of recordings, not needed where there is one force and one
        displacement; or the arrays, N and m, shape (n,), several records as lists of arrays.
        Positive work is done on the joint: the force has the sign of a spring's.
    time_step : float, optional
        Of arrays, s; or
    fs : float, optional
        their sampling rate, Hz. Only a viscous part and smoothing of the path need one.
    levels : Levels or sequence of Levels, optional
        Of the same joint, tables with errors of their own.
    stiffness : float, optional
        k of the stuck joint, N/m; found without it.
    viscous : bool
        Whether to seek a viscous part beside the friction.
    start : {"auto", "virgin", "unknown"}
        The state in which records begin; by what they show with ``"auto"``.
    samples : int
        Draws of the posterior; 100 or more.
    seed : int
        Of the draws.
    progress : callable, optional
        Called with (done, total) of the draws; False cancels.
    strict : bool
        Whether to raise where the method does not converge; without it a warning is issued.

    Returns
    -------
    RecordIdentification

    Raises
    ------
    ValueError
        Naming record or argument: a path that does not turn, work that is given, for instance.
    NotConverged
        With the result as far as it got.

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
        "start": one_of(start, "start", ("auto", "virgin", "unknown")),
        "samples": whole(samples, "samples", 100, 1_000_000),
        "seed": whole(seed, "seed", 0, 2**64 - 1),
    }
    found = _core.identify_records(
        given, _tables(levels), options, "microslip.identify_records", progress_of(progress)
    )
    return told(_found(found), strict)


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
