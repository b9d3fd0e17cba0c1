# SPDX-License-Identifier: MIT
"""Amplitude, frequency and damping of a mode over time, from its free decay."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from . import _core
from ._arguments import (
    ArrayLike,
    RealArray,
    flag,
    not_negative,
    positive,
    real,
    real_array,
    sequence,
    text,
)
from ._errors import InputError
from ._levels import Levels
from ._plot import plot_ring_down
from ._recordings import Recording
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of, warn_of

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

_MOTIONS = ("m", "m/s", "m/s^2")


class RingDownSensor(NamedTuple):
    """One of the sensors that recorded a decay."""

    name: str  #: name of the channel
    ratio: float  #: its amplitude over that of the first sensor, 1
    ratio_std: float  #: its standard deviation
    ratio_range: float  #: (largest - smallest)/mean of the ratio over the windows, 1


@dataclass(frozen=True, repr=False, eq=False)
class RingDownLevels(Shown):
    """Levels of a joint from a decay, one entry per level by falling amplitude.

    Attributes
    ----------
    amplitude, amplitude_std : ndarray
        Amplitude of the joint's displacement and its standard deviation, m, shape (n,).
    dissipation, dissipation_std : ndarray or None
        D and its standard deviation, J per cycle; None without a modal mass.
    secant_stiffness, secant_stiffness_std : ndarray or None
        k_eq and its standard deviation, N/m; None without the stiffness of the joint.
    time : ndarray
        Time of the level, s.
    frequency, frequency_std : ndarray
        Frequency of the mode and its standard deviation, Hz.
    damping_ratio, damping_ratio_std : ndarray
        zeta of the mode, linear part included, and its standard deviation, 1.
    flags : tuple of str
        Codes separated by blanks; docs/file_formats.md explains them under levels.csv.
    warnings : tuple of Note
        What was left out, and why.
    """

    amplitude: RealArray
    amplitude_std: RealArray
    dissipation: Optional[RealArray]
    dissipation_std: Optional[RealArray]
    secant_stiffness: Optional[RealArray]
    secant_stiffness_std: Optional[RealArray]
    time: RealArray
    frequency: RealArray
    frequency_std: RealArray
    damping_ratio: RealArray
    damping_ratio_std: RealArray
    flags: tuple[str, ...]
    warnings: tuple[Note, ...]

    def levels(self) -> Levels:
        """The levels as `Levels`, for `identify`."""
        if self.dissipation is None:
            raise InputError("dissipation is missing; give modal_mass to RingDown.levels")
        return Levels(
            self.amplitude,
            self.dissipation,
            amplitude_std=self.amplitude_std,
            dissipation_std=self.dissipation_std,
            secant_stiffness=self.secant_stiffness,
            secant_stiffness_std=self.secant_stiffness_std,
            frequency=self.frequency,
            frequency_std=self.frequency_std,
        )

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of levels.csv."""
        import pandas

        units = {"amplitude": "m", "dissipation": "J", "secant_stiffness": "N/m",
                 "frequency": "Hz", "damping_ratio": "1"}  # fmt: skip
        columns: dict[str, Any] = {}
        for name, unit in units.items():
            for column in (name, f"{name}_std"):
                if getattr(self, column) is not None:
                    columns[f"{column} [{unit}]"] = getattr(self, column)
        return pandas.DataFrame(
            {**columns, "decay_time [s]": self.time, "flags": list(self.flags)}
        )

    def __len__(self) -> int:
        return len(self.amplitude)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("levels", f"{len(self)}, by falling amplitude")]
        if len(self):
            a, f = self.amplitude, self.frequency
            rows.append(("amplitude", f"{si(a[0], '1')} to {si(a[-1], 'm')}"))
            rows.append(("frequency", f"{si(f[0], '1')} to {si(f[-1], 'Hz')}"))
        rows.extend(("warning", str(note)) for note in self.warnings)
        return "Levels of a ring-down", rows


@dataclass(frozen=True, repr=False, eq=False)
class RingDown(Shown):
    """A mode over time, one entry per window, of shape (windows,). Windows overlap; two that are
    half a window apart are nearly independent.

    Attributes
    ----------
    time : ndarray
        Centres of the windows, s, on the axis of the recording.
    amplitude, amplitude_std : ndarray
        Amplitude of the displacement at the (first) sensor and its standard deviation, m.
    frequency, frequency_std : ndarray
        Frequency and its standard deviation, Hz.
    damping_ratio, damping_ratio_std : ndarray
        zeta = (delta - 2 omega'/omega)/omega, 1.
    loss, loss_std : ndarray
        2 pi zeta omega**2 A**2 = D/m, J/kg.
    window : ndarray
        Lengths of the windows, s.
    flags : tuple of str
        Codes separated by blanks: ``clipped``, ``neighbour_leaks``, ``window_matters``,
        ``beats``, ``steady_tone``, ``shape_moves``, ``sensors_differ``.
    from_, to : float
        The range in which the windows lie, s.
    start : float
        Where free decay begins, s.
    start_by : str
        How the start was found: ``"given"``, ``"record"``, ``"blow"`` or ``"fall"``.
    blow : float or None
        Onset of the blow, s.
    band : tuple of float
        Frequency band, Hz: as given, or the pass band of the shortest window.
    sensors : tuple of RingDownSensor
        The sensors that were used.
    noise_std : float
        Standard deviation of the noise of a sample, in the unit of the signal.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        Why the decay was followed no further.
    """

    time: RealArray
    amplitude: RealArray
    amplitude_std: RealArray
    frequency: RealArray
    frequency_std: RealArray
    damping_ratio: RealArray
    damping_ratio_std: RealArray
    loss: RealArray
    loss_std: RealArray
    window: RealArray
    flags: tuple[str, ...]
    from_: float
    to: float
    start: float
    start_by: str
    blow: Optional[float]
    band: tuple[float, float]
    sensors: tuple[RingDownSensor, ...]
    noise_std: float
    warnings: tuple[Note, ...]
    summary: Summary

    def levels(
        self,
        modal_mass: Optional[float] = None,
        *,
        joint_ratio: float = 1.0,
        loss_factor: float = 0.0,
        stick_frequency: Optional[float] = None,
        joint_stiffness: Optional[float] = None,
    ) -> RingDownLevels:
        """Levels of the joint, half a window apart, so that they are nearly independent.

        Parameters
        ----------
        modal_mass : float, optional
            m, kg, above 0: the mode's mass at the (first) sensor, 1/phi**2. Without it no
            dissipation is computed.
        joint_ratio : float
            Joint displacement over displacement at the sensor, 1; not 0.
        loss_factor : float
            eta of the linear part, 1; 0 or more. Its loss is subtracted.
        stick_frequency : float, optional
            The mode's frequency with the joint stuck, Hz; by default the highest of the decay.
        joint_stiffness : float, optional
            k of the stuck joint, N/m. With it, and the stick frequency, k_eq is given.

        Raises
        ------
        ValueError
            Where a value breaks a rule; the message names it.
        """
        ratio = real(joint_ratio, "joint_ratio")
        state = {name: getattr(self, name) for name in _COLUMNS} | {"flags": list(self.flags)}
        if modal_mass is None:
            for name, value in (("loss_factor", loss_factor or None),
                                ("stick_frequency", stick_frequency),
                                ("joint_stiffness", joint_stiffness)):  # fmt: skip
                if value is not None:
                    raise InputError(f"{name} = {value}; must not be given without modal_mass."
                                     " Without it there is no dissipation to subtract it from.")  # fmt: skip
            return _levels_of(_core.ring_down_damping_levels(state, ratio))
        stick = None if stick_frequency is None else positive(stick_frequency, "stick_frequency")
        stiffness = None if joint_stiffness is None else positive(joint_stiffness, "joint_stiffness")
        mass = positive(modal_mass, "modal_mass")
        loss = not_negative(loss_factor, "loss_factor")
        return _levels_of(_core.ring_down_levels(state, mass, ratio, loss, stick, stiffness))

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with one row per window."""
        import pandas

        units = ("s", "m", "m", "Hz", "Hz", "1", "1", "J/kg", "J/kg", "s")
        columns = {f"{name} [{unit}]": getattr(self, name) for name, unit in zip(_COLUMNS, units)}
        return pandas.DataFrame({**columns, "flags": list(self.flags)})

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the damping ratio over the amplitude, by matplotlib."""
        return plot_ring_down(ax, style, self.amplitude, self.damping_ratio, self.damping_ratio_std)

    def __len__(self) -> int:
        return len(self.time)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        def span(values: RealArray, unit: str) -> str:
            return f"{si(values[0], '1')} to {si(values[-1], unit)}" if len(values) else "none"

        return "Ring-down", [
            ("sensors", ", ".join(sensor.name for sensor in self.sensors)),
            ("decay used", f"{self.from_:.4g} to {self.to:.4g} s"),
            ("windows", str(len(self))),
            ("amplitude", span(self.amplitude, "m")),
            ("frequency", span(self.frequency, "Hz")),
            ("damping ratio", span(self.damping_ratio, "1")),
        ] + outcome(self)


_COLUMNS = ("time", "amplitude", "amplitude_std", "frequency", "frequency_std", "damping_ratio",
            "damping_ratio_std", "loss", "loss_std", "window")  # fmt: skip


def _levels_of(found: dict[str, Any]) -> RingDownLevels:
    columns: dict[str, Any] = {
        name: None if name.startswith(("dissipation", "secant")) and not len(values) else values
        for name, values in found.items()
    }
    columns["flags"] = tuple(found["flags"])
    columns["warnings"] = notes(found["warnings"])
    levels = RingDownLevels(**columns)
    warn_of(found["warnings"])
    return levels


def _recording_of(signal: Any, fs: Any, time: Any, unit: Any) -> Recording:
    if isinstance(signal, Recording):
        for name, value in (("fs", fs), ("time", time), ("unit", unit)):
            if value is not None:
                raise InputError(f"{name} is given beside a recording, which has its own")
        return signal
    values = real_array(signal, "signal")
    if unit is None:
        raise InputError("unit is missing; must be that of the signal, for instance m/s^2")
    recording = Recording.of({"signal": values}, {"signal": unit}, fs=fs, time=time)
    if recording["signal"].unit not in _MOTIONS:
        raise InputError(f"unit = {unit!r}; must be one of displacement, velocity or acceleration")
    return recording


def _channels_of(recording: Recording, channel: Any) -> list[str]:
    """The given names, or that of the only motion channel."""
    if isinstance(channel, str):
        return [channel]
    if channel is not None:
        names = [text(name, "channel") for name in sequence(channel, "channel", "names")]
        if not names:
            raise InputError("channel is empty; must have at least one name")
        return names
    motions = [c.name for c in recording.channels if c.unit in _MOTIONS]
    if len(motions) != 1:
        raise InputError(f"channel is missing; {recording.source} has {len(motions)} motions"
                         f"{': ' if motions else ''}{', '.join(motions)}")  # fmt: skip
    return motions


def ring_down(
    signal: Union[Recording, ArrayLike],
    channel: Union[None, str, Sequence[str]] = None,
    *,
    fs: Optional[float] = None,
    time: Optional[ArrayLike] = None,
    unit: Optional[str] = None,
    frequency: Optional[float] = None,
    band: Optional[tuple[float, float]] = None,
    from_: Optional[float] = None,
    to: Optional[float] = None,
    least_periods: float = 6.0,
    least_fall: float = 0.4,
    largest_fall: float = 2.0,
    wanted_std: float = 0.005,
    largest_std: float = 0.1,
    strict: bool = True,
) -> RingDown:
    """Follows the free decay of one mode.

    Parameters
    ----------
    signal : Recording or array_like
        Displacement, velocity or acceleration, evenly sampled; an array has the shape (n,), in
        `unit`.
    channel : str or sequence of str, optional
        Channel of the recording, or several for the sensors of one blow; amplitudes are those of
        the first. Not needed where there is only one motion.
    fs, time : optional
        Sampling rate, Hz, or times, s, of an array.
    unit : str, optional
        Unit of an array: ``"m"``, ``"m/s"``, ``"m/s^2"``, ``"g"``, ...
    frequency : float, optional
        Frequency near which the mode is sought, within 10 %, Hz; by default the highest peak of the
        spectrum.
    band : (low, high), optional
        Frequency band, Hz, that contains the mode; the rest is filtered out.
    from_, to : float, optional
        Where the free decay begins and ends, s on the axis of the recording.
    least_periods : float
        Shortest length of a window in periods, where noise and other modes allow it; 3 or more.
    least_fall, largest_fall : float
        ln of the ratio of amplitudes over the shortest and the longest window; above 0, up to 6.
    wanted_std : float
        Relative standard deviation of zeta up to which windows are lengthened, 1; above 0.
    largest_std : float
        The decay ends where the longest window exceeds this standard deviation, 1; above 0.
    strict : bool
        Whether to raise where the decay was not followed to its end; otherwise a warning is issued.

    Returns
    -------
    RingDown

    Raises
    ------
    ValueError
        Where a value breaks a rule, which the message names, or there is no decay above the noise.
    NotConverged
        Where the decay was not followed to its end; holds the result up to there.

    Examples
    --------
    >>> import microslip, numpy as np
    >>> t = np.arange(8192) / 1024
    >>> decay = microslip.ring_down(np.exp(-0.01 * 2 * np.pi * 50 * t) * np.cos(2 * np.pi * 50 * t),
    ...                             fs=1024, unit="m")
    >>> bool(abs(decay.damping_ratio[0] - 0.01) < 1e-5)
    True
    """
    strict = flag(strict, "strict")
    recording = _recording_of(signal, fs, time, unit)
    ends = None
    if band is not None:
        low_high = real_array(band, "band", length=2, per="low and high, Hz")
        ends = (float(low_high[0]), float(low_high[1]))
    options = {
        "frequency": None if frequency is None else positive(frequency, "frequency"),
        "band": ends,
        "from": None if from_ is None else real(from_, "from_"),
        "to": None if to is None else real(to, "to"),
        "least_periods": positive(least_periods, "least_periods"),
        "least_fall": positive(least_fall, "least_fall"),
        "largest_fall": positive(largest_fall, "largest_fall"),
        "wanted_std": positive(wanted_std, "wanted_std"),
        "largest_std": positive(largest_std, "largest_std"),
    }
    found = _core.ring_down(recording._dict(), _channels_of(recording, channel), options)
    decay = RingDown(
        from_=found.pop("from"),
        sensors=tuple(RingDownSensor(*numbers) for numbers in found.pop("sensors")),
        flags=tuple(found.pop("flags")),
        warnings=notes(found.pop("warnings")),
        summary=summary_of(found.pop("summary")),
        **found,
    )
    return reported(decay, strict)
