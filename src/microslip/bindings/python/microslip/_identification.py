# SPDX-License-Identifier: MIT
"""Identifies a joint from levels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import _core
from ._arguments import (
    ArrayLike,
    Path,
    Progress,
    RealArray,
    flag,
    not_negative,
    one_of,
    positive,
    text,
    whole,
)
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._draws import JointDraws, draws_or_none
from ._errors import InputError
from ._joint import Joint
from ._levels import Levels
from ._plot import plot_identification
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes


class Parameter(NamedTuple):
    """A fitted parameter of a parametric model."""

    name: str  #: as in joint.json
    unit: str  #: unit of value and error
    value: float
    standard_error: float  #: 0 where the value is at a bound
    at_bound: bool  #: whether the best value lies at the end of the admissible range


class Verdict(NamedTuple):
    """Result of a check of one assumption about the joint."""

    departure: str  #: code of the departure sought, for instance ``order_matters``
    share: float  #: size of the departure over D, k_eq or the frequency, 1
    noise: float  #: the share that noise alone would make, of levels at most, 1
    broken: bool  #: whether the check failed


@dataclass(frozen=True, repr=False, eq=False)
class Identification(Shown):
    """A joint identified from levels, with its diagnostics.

    Attributes
    ----------
    joint : Joint
        The identified density, or the requested parametric model.
    method : str
        The method that was used.
    covered_from, covered_to : float
        kA of the lowest and the highest level, N: the data determine the density between them.
    slip_force, density : ndarray
        N and 1/N, shape (points,): of `joint`, for plots.
    lower, upper : ndarray or None
        1/N: pointwise band of 95 % of the draws; None without draws.
    linear_damping : float or None
        beta of a loss beta*A**2 in addition to slip, J/m**2; None where it was not identified.
    draws : JointDraws or None
        Posterior draws; None without `samples`.
    parameters : tuple of Parameter
        Parameters of a parametric model.
    verdicts : tuple of Verdict
        Checks of the assumptions about the joint.
    warnings : tuple of Note
        Warnings; docs/file_formats.md explains their codes under joint.json.
    summary : Summary
        How the method ended.
    """

    joint: Joint
    method: str
    covered_from: float
    covered_to: float
    slip_force: RealArray
    density: RealArray
    lower: Optional[RealArray]
    upper: Optional[RealArray]
    linear_damping: Optional[float]
    draws: Optional[JointDraws]
    parameters: tuple[Parameter, ...]
    verdicts: tuple[Verdict, ...]
    warnings: tuple[Note, ...]
    summary: Summary
    _json: str

    def write(self, path: Path) -> None:
        """Writes a joint.json, as the program does: with its provenance, the range covered, the
        band and the warnings."""
        _core.write_file(path_of(path, "path"), self._json.encode())

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of density.csv."""
        import pandas

        columns = {"slip_force [N]": self.slip_force, "density [1/N]": self.density}
        if self.lower is not None and self.upper is not None:
            columns |= {"lower [1/N]": self.lower, "upper [1/N]": self.upper}
        return pandas.DataFrame(columns)

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the density with its band, by matplotlib."""
        band = None
        if self.lower is not None and self.upper is not None:
            band = self.lower, self.upper
        return plot_identification(
            ax, style, self.slip_force, self.density, self.joint._atoms(), band=band,
            covered_from=self.covered_from,
            up_to=max(self.covered_to, 1.05 * self.joint._core.largest_slip_force),
        )  # fmt: skip

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [
            ("method", self.method),
            ("stiffness", si(self.joint.stiffness, "N/m")),
            ("covered", f"{si(self.covered_from, '1')} to {si(self.covered_to, 'N')}"),
            ("elastic remainder", f"{self.joint.elastic_remainder:.4g}"),
        ]
        if self.linear_damping is not None:
            rows.append(("linear damping", si(self.linear_damping, "J/m^2")))
        rows.extend(
            (p.name, f"{si(p.value, p.unit)} +- {p.standard_error:.2g}") for p in self.parameters
        )
        if self.draws is not None:
            rows.append(("draws", str(len(self.draws))))
        return "Identification", rows + outcome(self)


def _levels_of(amplitude: Any, dissipation: Any, columns: dict[str, Any]) -> Levels:
    given = {name: value for name, value in columns.items() if value is not None}
    if dissipation is not None:
        return Levels(amplitude, dissipation, **given)
    if given:
        raise InputError(f"{next(iter(given))} is given beside a table; it must be a column of it")
    if isinstance(amplitude, Levels) or hasattr(amplitude, "keys"):
        return Levels.of(amplitude)
    raise InputError("dissipation is missing; must be an array, or a table must be given")


def identify(
    amplitude: Union[ArrayLike, Levels, pandas.DataFrame],
    dissipation: Optional[ArrayLike] = None,
    *,
    stiffness: float,
    amplitude_std: Optional[ArrayLike] = None,
    dissipation_std: Optional[ArrayLike] = None,
    secant_stiffness: Optional[ArrayLike] = None,
    secant_stiffness_std: Optional[ArrayLike] = None,
    linear_dissipation: Optional[ArrayLike] = None,
    frequency: Optional[ArrayLike] = None,
    frequency_std: Optional[ArrayLike] = None,
    method: str = "inversion",
    smoothing: str = "gcv",
    smoothing_unit: Optional[str] = None,
    linear_damping: bool = False,
    atom: bool = False,
    edges: bool = True,
    fit: Optional[str] = None,
    samples: int = 0,
    seed: int = 1,
    dissipation_gain_std: float = 0.0,
    amplitude_gain_std: float = 0.0,
    loss_factor_std: float = 0.0,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> Identification:
    """Identifies the joint whose dissipation was measured.

    Parameters
    ----------
    amplitude : array_like, Levels or DataFrame
        A of the joint displacement, m, shape (n,); or a table of levels, see `Levels.of`.
    dissipation : array_like
        D, J per cycle, shape (n,); left out with a table.
    stiffness : float
        k of the stuck joint, N/m; above 0. It scales the slip forces: f* = kA.
    amplitude_std, dissipation_std, secant_stiffness, secant_stiffness_std : array_like, optional
    linear_dissipation, frequency, frequency_std : array_like, optional
        As of `Levels`.
    method : {"inversion", "spline", "differences"}
        Method by which the density is identified.
    smoothing, smoothing_unit : str
        ``"gcv"``: chosen automatically; ``"lambda=X"``; ``"p=X"`` of csaps (spline only), with the
        unit of the amplitude that it applies to: ``"um"``, ``"mm"``, ``"m"``.
    linear_damping : bool
        Whether D contains a linear damping beta*A**2 that is to be identified as well.
    atom : bool
        Whether to seek an atom of the density where macro-slip begins.
    edges : bool
        Whether the density may jump where the levels make it very likely.
    fit : {"four_parameter", "power_law", "uniform"}, optional
        A parametric model in place of the free density.
    samples : int
        Number of posterior draws, also for the band; 0: none, else 20 or more. 1000 give a smooth
        band.
    seed : int
        Seed of the draws.
    dissipation_gain_std, amplitude_gain_std, loss_factor_std : float
        Relative standard deviations of errors that all levels share, 1; below 0.3.
    progress : callable, optional
        Called with (done, total) of the draws; False cancels.
    strict : bool
        Whether to raise where the method does not converge; otherwise a warning is issued.

    Returns
    -------
    Identification

    Raises
    ------
    ValueError
        Where an argument breaks a rule; the message names it.
    NotConverged
        Where the method does not converge; holds the result up to there.

    Examples
    --------
    >>> import microslip, numpy as np
    >>> truth = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> amplitude = np.linspace(2e-6, 1e-4, 40)
    >>> found = microslip.identify(amplitude, truth.dissipation(amplitude), stiffness=1e5)
    >>> bool(abs(found.joint.force(8e-5) / truth.force(8e-5) - 1) < 2e-3)
    True
    """
    strict = flag(strict, "strict")
    levels = _levels_of(
        amplitude,
        dissipation,
        {
            "amplitude_std": amplitude_std,
            "dissipation_std": dissipation_std,
            "secant_stiffness": secant_stiffness,
            "secant_stiffness_std": secant_stiffness_std,
            "linear_dissipation": linear_dissipation,
            "frequency": frequency,
            "frequency_std": frequency_std,
        },
    )
    options = {
        "method": one_of(method, "method", ("inversion", "spline", "differences")),
        "smoothing": text(smoothing, "smoothing"),
        "smoothing_unit": None if smoothing_unit is None else text(smoothing_unit, "smoothing_unit"),
        "linear_damping": flag(linear_damping, "linear_damping"),
        "atom": flag(atom, "atom"),
        "edges": flag(edges, "edges"),
        "fit": None if fit is None else one_of(fit, "fit", ("four_parameter", "power_law", "uniform")),
        "samples": whole(samples, "samples", 0, 1_000_000),
        "seed": whole(seed, "seed", 0, 2**64 - 1),
        "dissipation_gain_std": not_negative(dissipation_gain_std, "dissipation_gain_std"),
        "amplitude_gain_std": not_negative(amplitude_gain_std, "amplitude_gain_std"),
        "loss_factor_std": not_negative(loss_factor_std, "loss_factor_std"),
    }  # fmt: skip
    found = _core.identify_levels(
        levels._columns(), positive(stiffness, "stiffness"), options, "microslip.identify",
        [(note.code, note.text) for note in levels._notes], progress_of(progress),
    )  # fmt: skip
    return reported(_identification_of(found), strict)


def _identification_of(found: dict[str, Any]) -> Identification:
    return Identification(
        joint=Joint._of(found["joint"]),
        method=found["method"],
        covered_from=found["covered_from"],
        covered_to=found["covered_to"],
        slip_force=found["slip_force"],
        density=found["density"],
        lower=found["lower"],
        upper=found["upper"],
        linear_damping=found["linear_damping"],
        draws=draws_or_none(found["draws"]),
        parameters=tuple(Parameter(*numbers) for numbers in found["parameters"]),
        verdicts=tuple(Verdict(*numbers) for numbers in found["verdicts"]),
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
        _json=found["json"],
    )
