# SPDX-License-Identifier: MIT
"""Steady vibrations by harmonic balance: frequency responses and backbones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    ComplexArray,
    Progress,
    RealArray,
    flag,
    one_of,
    positive,
    real,
    real_array,
    shown,
    text,
    whole,
)
from ._arguments import progress as progress_of
from ._errors import InputError
from ._plot import plot_curve
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of
from ._spread import Band, DrawsOrCount, PeakBand, Spread, drawn
from ._structure import Structure

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

KINDS = ("displacement", "velocity", "acceleration")
_UNITS = {"displacement": "m", "velocity": "m/s", "acceleration": "m/s^2"}


@dataclass(frozen=True, eq=False)
class JointCycles:
    """The cycles of one joint along a curve.

    Attributes
    ----------
    name : str
    amplitude : ndarray
        Half the range of u, m, shape (points,).
    dissipation : ndarray
        D, the whole loss of the joint, J per cycle, shape (points,).
    linear_dissipation : ndarray
        The part of D that is not slip, J per cycle, shape (points,).
    reversals : ndarray
        Reversals per cycle, shape (points,); 2 without inner loops.
    displacement, force : ndarray
        Harmonics 0 to H, factors of exp(i n omega t), m and N, shape (points, H + 1).
    """

    name: str
    amplitude: RealArray
    dissipation: RealArray
    linear_dissipation: RealArray
    reversals: RealArray
    displacement: ComplexArray
    force: ComplexArray


@dataclass(frozen=True, eq=False)
class Vibrations:
    """Steady vibrations, in the order of a curve.

    Attributes
    ----------
    frequency : ndarray
        Frequency, Hz, shape (points,).
    force : ndarray
        Amplitude of the excitation, N, or m/s**2 of a base, shape (points,).
    response : ndarray
        Amplitude of the first harmonic at the response point, in its kind, shape (points,).
    phase_lag : ndarray
        Phase lag of the displacement there behind the force, rad, in (-pi, pi], shape (points,).
    damping_ratio : ndarray
        Damping ratio from the energy lost per cycle, 1, shape (points,).
    input_energy, linear_dissipation : ndarray
        Energy fed in and lost by the linear part, J per cycle, shape (points,). [AR14 (15) to (17)]
    energy_imbalance : ndarray
        Residual of the energy balance, 1, shape (points,): how well the equations are solved.
    modal : ndarray
        Harmonics q_i,n, kg**0.5 m, shape (points, modes, H + 1).
    joints : tuple of JointCycles
        One per joint of the structure.
    """

    frequency: RealArray
    force: RealArray
    response: RealArray
    phase_lag: RealArray
    damping_ratio: RealArray
    input_energy: RealArray
    linear_dissipation: RealArray
    energy_imbalance: RealArray
    modal: ComplexArray
    joints: tuple[JointCycles, ...]

    def __len__(self) -> int:
        return len(self.frequency)


@dataclass(frozen=True, repr=False, eq=False)
class ResponseCurve(Shown):
    """A curve of steady vibrations.

    Attributes
    ----------
    points : Vibrations
        In the order of the curve, the peaks among them.
    peaks : Vibrations
        Local maxima of the response over the force.
    peak_points, turning_points : ndarray of int
        Indices of the points that are peaks, and of those where the curve turns back.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        Why the curve ended, and where.
    """

    points: Vibrations
    peaks: Vibrations
    peak_points: Any
    turning_points: Any
    warnings: tuple[Note, ...]
    summary: Summary
    _structure: Structure
    _kind: str

    @property
    def frequency(self) -> RealArray:
        """Frequencies of the points, Hz."""
        return self.points.frequency

    @property
    def response(self) -> RealArray:
        """Responses of the points, in the requested kind."""
        return self.points.response

    @property
    def unit(self) -> str:
        """Unit of the response: ``"m"``, ``"m/s"`` or ``"m/s^2"``."""
        return _UNITS[self._kind]

    def displacement(self, point: str) -> ComplexArray:
        """The displacement at a point of the structure, relative to its base: harmonics 0 to H, m,
        shape (points, H + 1)."""
        shapes = self._structure.points
        shape = shapes[one_of(point, "point", tuple(shapes))]
        harmonics: ComplexArray = np.einsum("i,pin->pn", shape, self.points.modal)
        return harmonics

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the numbers of the points and joints."""
        import pandas

        drive = "base_acceleration [m/s^2]" if self._structure.base_driven else "force [N]"
        columns = {
            "frequency [Hz]": self.points.frequency,
            drive: self.points.force,
            f"response [{self.unit}]": self.points.response,
            "phase_lag [rad]": self.points.phase_lag,
            "damping_ratio [1]": self.points.damping_ratio,
            "linear_dissipation [J]": self.points.linear_dissipation,
            "energy_imbalance [1]": self.points.energy_imbalance,
        }
        for joint in self.points.joints:
            columns[f"amplitude_{joint.name} [m]"] = joint.amplitude
            columns[f"dissipation_{joint.name} [J]"] = joint.dissipation
        return pandas.DataFrame(columns)

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the response over the frequency, by matplotlib."""
        return plot_curve(
            ax, style, self.frequency, self.response, f"{self._kind} [{self.unit}]",
            peaks=(self.peaks.frequency, self.peaks.response), band=self._response_band(),
        )  # fmt: skip

    def _response_band(self) -> Optional[Band]:
        """Band of the response, where there are draws."""
        return None

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("points", str(len(self.points)))]
        if len(self.points):
            f, r = self.frequency, self.response
            rows.append(("frequency", f"{si(f.min(), '1')} to {si(f.max(), 'Hz')}"))
            rows.append(("response", f"{si(r.min(), '1')} to {si(r.max(), self.unit)}"))
        rows.extend(
            ("peak", f"{si(r, self.unit, 6)} at {si(f, 'Hz', 6)}")
            for f, r in zip(self.peaks.frequency, self.peaks.response)
        )
        return "Response curve", rows + outcome(self)


@dataclass(frozen=True, repr=False, eq=False)
class ResponseBand(ResponseCurve):
    """A curve over the frequency with its band over draws: a `ResponseCurve` with

    Attributes
    ----------
    lower, upper : ndarray
        Band of the response, or of the force at constant response, at the frequency of each point,
        shape (points,).
    peak_bands : tuple of PeakBand
        One per peak.
    failures : tuple of (str, int)
        Reasons why draws failed, and how many; these are in no band.
    """

    lower: RealArray
    upper: RealArray
    peak_bands: tuple[PeakBand, ...]
    failures: tuple[tuple[str, int], ...]
    _of_force: bool

    def _response_band(self) -> Optional[Band]:
        return None if self._of_force else (self.lower, self.upper)


@dataclass(frozen=True, repr=False, eq=False)
class BackboneBand(ResponseCurve):
    """Resonances with their bands over draws: a `ResponseCurve` with

    Attributes
    ----------
    force_band, frequency_band, damping_ratio_band : (ndarray, ndarray)
        Lower and upper end, N, Hz and 1, one value per point each.
    failures : tuple of (str, int)
        Reasons why draws failed, and how many; these are in no band.
    """

    force_band: Band
    frequency_band: Band
    damping_ratio_band: Band
    failures: tuple[tuple[str, int], ...]


@dataclass(frozen=True, repr=False, eq=False)
class Vibration(Shown):
    """One steady vibration, as `Vibrations` of one point.

    Attributes
    ----------
    points : Vibrations
        The vibration, of length 1.
    summary : Summary
        How the solution ended.
    """

    points: Vibrations
    summary: Summary
    warnings: tuple[Note, ...] = ()

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        points = self.points
        return "Vibration", [
            ("frequency", si(float(points.frequency[0]), "Hz")),
            ("force", si(float(points.force[0]), "1")),
            ("response", si(float(points.response[0]), "1")),
            ("phase lag", si(float(points.phase_lag[0]), "rad")),
            ("damping ratio", si(float(points.damping_ratio[0]), "1")),
        ] + outcome(self)


class HarmonicBalance:
    """Steady periodic vibrations of a jointed structure, with the exact memory of its joints.

    Immutable: one object serves any number of threads, beside each other.

    Parameters
    ----------
    structure : Structure
        The vibrating structure.
    point : str, optional
        Point where the response is measured; by default that of the model.toml, else the driven
        point, or the first point with a base excitation.
    kind : {"displacement", "velocity", "acceleration"}
        Kind of the response.
    harmonics : int
        H: harmonics 0 to H are kept; 1 or more. 3 suffice where the joint hardly slips, 9 in
        macro-slip.
    samples : int
        Samples per cycle for the joint forces; 2 H + 2 or more.
    tolerance : float
        Largest residual, relative, 1; 1e-14 to 1e-4.
    max_iterations : int
        Evaluations of the equations that one solution may take; 2 or more.
    largest_change : float
        Largest change of the response between points of a curve, relative, 1; in (0, 1].
    least_points, max_points : int
        Numbers of points of a curve.
    accuracy : float
        Largest interpolation error of the polygon through the points, relative to the peak, 1; 0:
        no points are added.
    frequencies : array_like, optional
        Additional frequencies of points of a curve over the frequency, Hz.
    modal_forcing : bool
        Whether a force on every mode keeps the vibration up, which leaves nonlinear modes. [Krack
        2015]

    Raises
    ------
    ValueError
        Naming what breaks a rule.
    """

    __slots__ = ("_core", "_kind", "structure")
    structure: Structure

    def __init__(
        self,
        structure: Structure,
        point: Optional[str] = None,
        *,
        kind: str = "displacement",
        harmonics: int = 5,
        samples: int = 256,
        tolerance: float = 1e-12,
        max_iterations: int = 40,
        largest_change: float = 0.2,
        least_points: int = 20,
        max_points: int = 5000,
        accuracy: float = 0.002,
        frequencies: Optional[ArrayLike] = None,
        modal_forcing: bool = False,
    ) -> None:
        if not isinstance(structure, Structure):
            raise InputError(f"structure = {shown(structure)}; must be a microslip.Structure")
        hertz = None if frequencies is None else real_array(frequencies, "frequencies")
        self._kind = one_of(kind, "kind", KINDS)
        options = {
            "harmonics": whole(harmonics, "harmonics", 1),
            "samples": whole(samples, "samples", 1),
            "tolerance": positive(tolerance, "tolerance"),
            "max_iterations": whole(max_iterations, "max_iterations", 1),
            "largest_change": positive(largest_change, "largest_change"),
            "least_points": whole(least_points, "least_points", 1),
            "max_points": whole(max_points, "max_points", 1),
            "accuracy": real(accuracy, "accuracy"),
            "angular_frequencies": None if hertz is None else 2.0 * np.pi * hertz,
            "modal_forcing": flag(modal_forcing, "modal_forcing"),
        }
        self.structure = structure
        at = structure._core.response if point is None else text(point, "point")
        self._core = _core.HarmonicBalance(structure._core, at, self._kind, options)

    def frequency_response(
        self,
        force: float,
        from_: float,
        to: float,
        *,
        draws: Optional[DrawsOrCount] = None,
        samples: DrawsOrCount = 0,
        seed: int = 1,
        confidence: float = 0.95,
        correlation: str = "auto",
        spread: Optional[Spread] = None,
        progress: Optional[Progress] = None,
        strict: bool = True,
    ) -> ResponseCurve:
        """The curve over the frequency at constant force.

        Parameters
        ----------
        force : float
            Amplitude, N, or m/s**2 of a base; above 0.
        from_, to : float
            Ends of the curve, Hz, in either order.
        draws : JointDraws, or one or None per joint, or mapping of names, or int, optional
            Posterior draws of the joints; a linear damping drawn with them is used.
        samples : int, or draws of joints
            Number of predictions by draws of `draws` and `spread`; 0: none, else
            2/(1 - confidence) or more. As with the options of the program, the two may also be the
            other way round: ``draws=1000, samples=found.draws``.
        seed : int
            Seed of the draws.
        confidence : float
            Share of the draws in a band, in (0, 1).
        correlation : {"auto", "together", "independent"}
            Whether draws of several joints are paired by number: only where one calibration drew
            them, always, never.
        spread : Spread, optional
            Further uncertainties.
        progress : callable, optional
            Called with (done, total), with draws of these afterwards; False cancels.
        strict : bool
            Whether to raise where the curve did not reach its end; otherwise a warning is issued.

        Returns
        -------
        ResponseCurve
            A `ResponseBand` with draws, unless the curve did not converge.

        Raises
        ------
        ValueError, NotConverged
        """
        strict = flag(strict, "strict")
        asked = drawn(self.structure, draws, samples, seed, confidence, correlation, spread)
        return self._follow("force", positive(force, "force"), from_, to, asked, progress, strict)

    def constant_response(
        self,
        response: float,
        from_: float,
        to: float,
        *,
        draws: Optional[DrawsOrCount] = None,
        samples: DrawsOrCount = 0,
        seed: int = 1,
        confidence: float = 0.95,
        correlation: str = "auto",
        spread: Optional[Spread] = None,
        progress: Optional[Progress] = None,
        strict: bool = True,
    ) -> ResponseCurve:
        """The force over the frequency at constant response. [AR14 Fig. 4] Parameters as of
        `frequency_response`; `response` in the kind of this object."""
        strict = flag(strict, "strict")
        asked = drawn(self.structure, draws, samples, seed, confidence, correlation, spread)
        kept = positive(response, "response")
        return self._follow("response", kept, from_, to, asked, progress, strict)

    def backbone(
        self,
        response: ArrayLike,
        *,
        mode: int = 0,
        through_folds: bool = True,
        draws: Optional[DrawsOrCount] = None,
        samples: DrawsOrCount = 0,
        seed: int = 1,
        confidence: float = 0.95,
        correlation: str = "auto",
        spread: Optional[Spread] = None,
        progress: Optional[Progress] = None,
        strict: bool = True,
    ) -> ResponseCurve:
        """The backbone: vibrations in phase resonance.

        Parameters
        ----------
        response : array_like
            Amplitudes, in the kind of this object, shape (n,); above 0, rising.
        mode : int
            Mode of the stuck structure, by frequency, from 0.
        through_folds : bool
            Whether to follow the curve from where all joints stick, round folds, where a response
            may occur more than once; always so with draws. Otherwise each response is solved by
            itself, in any order.
        draws, samples, seed, confidence, correlation, spread, progress, strict
            As of `frequency_response`; with draws the result is a `BackboneBand`.
        """
        strict = flag(strict, "strict")
        asked = drawn(self.structure, draws, samples, seed, confidence, correlation, spread)
        at = real_array(response, "response")
        number, folds = whole(mode, "mode"), flag(through_folds, "through_folds")
        listener = progress_of(progress)
        if asked is None:
            found = self._core.follow_backbone(at, number, folds, listener)
        else:
            found = _core.draw_backbone(self._core, at, number, asked, listener)
        return self._curve(found, strict)

    def solve(self, *, frequency: Optional[float] = None, force: Optional[float] = None,
              response: Optional[float] = None, phase_lag: Optional[float] = None, mode: int = 0,
              strict: bool = True) -> Vibration:  # fmt: skip
        """The vibration with two of its quantities given.

        Parameters
        ----------
        frequency : float, optional
            Frequency, Hz.
        force : float, optional
            Amplitude, N, or m/s**2 of a base.
        response : float, optional
            Amplitude, in the kind of this object.
        phase_lag : float, optional
            Phase lag, rad, in (0, pi); pi/2 is phase resonance.
        mode : int
            Mode whose resonance is sought where no frequency is given.
        strict : bool
            As of `frequency_response`.
        """
        strict = flag(strict, "strict")
        given = {"angular_frequency": None if frequency is None else
                 2.0 * np.pi * positive(frequency, "frequency"),
                 "force": None if force is None else positive(force, "force"),
                 "response": None if response is None else positive(response, "response"),
                 "phase_lag": None if phase_lag is None else positive(phase_lag, "phase_lag")}  # fmt: skip
        targets = [(name, value) for name, value in given.items() if value is not None]
        if len(targets) != 2:
            raise InputError(f"{len(targets)} of frequency, force, response, phase_lag are given;"
                             " must be two")  # fmt: skip
        found = self._core.solve(targets[0], targets[1], whole(mode, "mode"))
        result = Vibration(_vibrations(found["points"]), summary_of(found["summary"]),
                           notes(found["warnings"]))  # fmt: skip
        return reported(result, strict)

    def _follow(self, kept: str, value: float, from_: object, to: object,
                asked: Optional[dict[str, Any]], progress: object,
                strict: bool) -> ResponseCurve:  # fmt: skip
        a, b = 2.0 * np.pi * positive(from_, "from_"), 2.0 * np.pi * positive(to, "to")
        listener = progress_of(progress)
        if asked is None:
            found = self._core.follow_frequency(kept, value, a, b, listener)
        else:
            found = _core.draw_frequency(self._core, kept, value, a, b, asked, listener)
            found["of_force"] = kept == "response"
        return self._curve(found, strict)

    def _curve(self, found: dict[str, Any], strict: bool) -> ResponseCurve:
        spread = found.get("spread")
        more = [] if spread is None else spread["warnings"]
        parts: dict[str, Any] = {
            "points": _vibrations(found["points"]),
            "peaks": _vibrations(found["peaks"]),
            "peak_points": np.array(found["peak_points"], dtype=int),
            "turning_points": np.array(found["turning_points"], dtype=int),
            "warnings": notes([*found["warnings"], *more]),
            "summary": summary_of(found["summary"]),
            "_structure": self.structure,
            "_kind": self._kind,
        }
        curve = _with_bands(parts, spread, found.get("of_force", False))
        return reported(curve, strict)

    def __reduce__(self) -> tuple[Any, ...]:
        return _balance_of, (self.structure, self._core.point, self._kind, self._core.options())

    def __repr__(self) -> str:
        return f"HarmonicBalance({self._core.point!r}, kind={self._kind!r})"


def _with_bands(parts: dict[str, Any], spread: Optional[dict[str, Any]],
                of_force: bool) -> ResponseCurve:  # fmt: skip
    if spread is None:
        return ResponseCurve(**parts)
    failures = tuple(spread["failures"])
    if "height" not in spread:
        bands = {f"{name}_band": spread[name] for name in ("force", "frequency", "damping_ratio")}
        return BackboneBand(**parts, **bands, failures=failures)
    lower, upper = spread["height"]
    peaks = tuple(PeakBand(*numbers) for numbers in spread["peaks"])
    return ResponseBand(**parts, lower=lower, upper=upper, peak_bands=peaks, failures=failures,
                        _of_force=of_force)  # fmt: skip


def _balance_of(structure: Structure, point: str, kind: str, options: Any) -> HarmonicBalance:
    balance = object.__new__(HarmonicBalance)
    balance.structure = structure
    balance._kind = kind
    balance._core = _core.HarmonicBalance(structure._core, point, kind, options)
    return balance


def _vibrations(columns: dict[str, Any]) -> Vibrations:
    numbers: dict[str, Any] = dict(columns)
    numbers["joints"] = tuple(JointCycles(**joint) for joint in columns["joints"])
    return Vibrations(**numbers)


#: Arguments of a curve that are no options of the solution.
_OF_RUN = ("draws", "seed", "confidence", "correlation", "spread", "progress", "strict")


def _taken(options: dict[str, Any], names: tuple[str, ...]) -> dict[str, Any]:
    """Takes arguments out of the options."""
    if options.get("draws") is not None or options.get("spread") is not None:
        names = (*names, "samples")
    return {name: options.pop(name) for name in names if name in options}


def frequency_response(structure: Structure, force: float, from_: float, to: float,
                       **options: Any) -> ResponseCurve:  # fmt: skip
    """The response of a structure over the frequency at constant force.

    Parameters
    ----------
    structure : Structure
        The vibrating structure.
    force : float
        Amplitude, N, or m/s**2 of a base; above 0.
    from_, to : float
        Ends of the curve, Hz.
    **options
        Those of `HarmonicBalance` (`point`, `kind`, `harmonics`, ...), and `draws`, `spread`,
        `progress`, `strict`, ... of `HarmonicBalance.frequency_response`. With `draws` or `spread`,
        `samples` is the number of draws, else the samples per cycle.

    Examples
    --------
    >>> import microslip
    >>> joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
    >>> structure = microslip.Structure(
    ...     [10.0], {"mass": [2**-0.5]}, damping_ratio=0.01,
    ...     joints=[microslip.StructuralJoint(joint, [2**-0.5])])
    >>> curve = microslip.frequency_response(structure, 0.5, 30, 40)
    >>> print(f"{curve.peaks.response[0]:.3g} {curve.unit} at {curve.peaks.frequency[0]:.4g} Hz")
    4.73e-05 m at 32.66 Hz
    """
    run = _taken(options, _OF_RUN)
    return HarmonicBalance(structure, **options).frequency_response(force, from_, to, **run)


def backbone(structure: Structure, response: ArrayLike, **options: Any) -> ResponseCurve:
    """The backbone of a structure: its vibrations in phase resonance, over the response.

    Parameters
    ----------
    structure : Structure
        The vibrating structure.
    response : array_like
        Amplitudes, in the kind of the response, shape (n,).
    **options
        Those of `HarmonicBalance` and of `HarmonicBalance.backbone`.
    """
    run = _taken(options, ("mode", "through_folds", *_OF_RUN))
    return HarmonicBalance(structure, **options).backbone(response, **run)
