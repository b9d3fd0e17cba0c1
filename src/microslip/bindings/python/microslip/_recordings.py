# SPDX-License-Identifier: MIT
"""Recordings: signals measured together, read from and written to files and dictionaries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _core
from ._arguments import (
    ArrayLike,
    ComplexArray,
    Path,
    Progress,
    RealArray,
    attributes,
    flag,
    one_of,
    positive,
    real,
    real_array,
    real_or_complex_array,
    sequence,
    text,
)
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._errors import InputError
from ._plot import plot_signals
from ._results import Shown, si, warn_of

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

FORMATS = ("csv", "uff", "uff-ascii", "mat", "h5")
#: Strings by name, in the order of a file, where a name may occur repeatedly.
Attributes = tuple[tuple[str, str], ...]


@dataclass(frozen=True, repr=False, eq=False)
class Channel(Shown):
    """One signal. Its values are in SI.

    Parameters
    ----------
    name : str
        Name, unique within a recording.
    values : array_like
        Real or complex, shape (points,), in `unit`; they become SI.
    unit : str, optional
        ``"m/s^2"``, ``"g"`` (standard gravity), ``"um"``, ``"lbf"``, ``"1"``, ...; it becomes that
        of SI. None: not known, values stay as they are.
    attributes : mapping or sequence of (str, str)
        Further information on the signal.

    Raises
    ------
    ValueError
        Where a value breaks a rule, for instance an unknown unit; the message names it.
    """

    name: str
    values: ArrayLike
    unit: Optional[str] = None
    attributes: Union[Attributes, Mapping[str, str]] = ()

    def __post_init__(self) -> None:
        text(self.name, "name")
        values = real_or_complex_array(self.values, f"values of {self.name!r}")
        unit = self.unit
        if unit is not None:
            numerator, denominator, unit = _core.unit(text(unit, f"unit of {self.name!r}"))
            if numerator != 1.0 or denominator != 1.0:
                values = values * numerator / denominator
        object.__setattr__(self, "values", values)
        object.__setattr__(self, "unit", unit)
        object.__setattr__(self, "attributes", attributes(self.attributes, "attributes"))

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        size = np.abs(np.asarray(self.values))
        unit = "1" if self.unit is None else self.unit
        rows = [("points", str(size.size)), ("unit", self.unit or "not known"),
                ("rms", si(float(np.sqrt(np.mean(size * size))), unit)),
                ("largest", si(float(size.max()), unit))]  # fmt: skip
        return f"Channel {self.name}", rows + list(attributes(self.attributes, "attributes"))


@dataclass(frozen=True, eq=False)
class Axis:
    """The axis of the values, usually time.

    Parameters
    ----------
    values : array_like, optional
        Points in `unit`, rising, where they are not evenly spaced; or
    step : float
        Their spacing in `unit`, above 0, where they are.
    start : float
        The first point, in `unit`, with a step.
    unit : str
        ``"s"``, ``"Hz"``, ...; it becomes that of SI.
    """

    values: Optional[ArrayLike] = None
    step: float = 0.0
    start: float = 0.0
    unit: str = "s"
    _count: Optional[int] = field(default=None, init=False, repr=False)

    def __post_init__(self) -> None:
        numerator, denominator, unit = _core.unit(text(self.unit, "unit of the axis"))
        if self.values is None:
            step = positive(self.step, "step") * numerator / denominator
            start = real(self.start, "start") * numerator / denominator
            values = None
        else:
            array = real_array(self.values, "values of the axis") * numerator / denominator
            values, start, step = _evenly(array)
            object.__setattr__(self, "_count", len(array))
        for name, value in zip(("values", "step", "start", "unit"), (values, step, start, unit)):
            object.__setattr__(self, name, value)

    @property
    def even(self) -> bool:
        """Whether the points are evenly spaced."""
        return self.values is None

    def points(self, count: int) -> RealArray:
        """The first `count` points, SI."""
        if self.values is None:
            return self.start + np.arange(count) * self.step
        return np.asarray(self.values)[:count]


def _evenly(points: RealArray) -> tuple[Optional[RealArray], float, float]:
    """Start and step where these reproduce the points to the rounding of a few operations."""
    if len(points) < 2:
        return points, 0.0, 0.0
    start = float(points[0])
    step = float(points[-1] - points[0]) / (len(points) - 1)
    off = np.abs(points - (start + np.arange(len(points)) * step)).max()
    if step > 0.0 and off <= 8.0 * np.finfo(float).eps * np.abs(points).max():
        return None, start, step
    return points, 0.0, 0.0


@dataclass(frozen=True, repr=False, eq=False)
class Recording(Shown):
    """Channels measured together, over one axis. ``recording["force"]`` is a channel of it.

    Parameters
    ----------
    channels : sequence of Channel
        One at least, each with one value per point of the axis.
    axis : Axis
        The axis that they share.
    source : str
        Where the recording comes from, for messages and tables.
    attributes : mapping or sequence of (str, str)
        Further information on the recording.

    Raises
    ------
    ValueError
        Where lengths differ, names occur twice or times do not rise, for instance; the message
        names the value.

    See Also
    --------
    Recording.of : from arrays
    read_recordings : from files
    """

    channels: Sequence[Channel]
    axis: Axis
    source: str = "arrays"
    attributes: Union[Attributes, Mapping[str, str]] = ()

    def __post_init__(self) -> None:
        given = sequence(self.channels, "channels", "microslip.Channel")
        for i, channel in enumerate(given):
            if not isinstance(channel, Channel):
                raise InputError(f"channels[{i}] = {channel!r}; must be a microslip.Channel")
        if not isinstance(self.axis, Axis):
            raise InputError(f"axis = {self.axis!r}; must be a microslip.Axis")
        text(self.source, "source")
        object.__setattr__(self, "channels", tuple(given))
        object.__setattr__(self, "attributes", attributes(self.attributes, "attributes"))
        _core.check_recording(self._dict())
        if self.axis._count not in (None, len(self)):
            raise InputError(f"{self.source}: the axis has {self.axis._count} points; must have"
                             f" {len(self)}, one per value")  # fmt: skip

    @classmethod
    def of(
        cls,
        signals: Mapping[str, ArrayLike],
        units: Optional[Mapping[str, str]] = None,
        *,
        fs: Optional[float] = None,
        time: Optional[ArrayLike] = None,
        frequency: Optional[ArrayLike] = None,
        start: float = 0.0,
        source: str = "arrays",
    ) -> Recording:
        """A recording from arrays.

        Parameters
        ----------
        signals : mapping of str to array_like
            Values by name, shape (points,).
        units : mapping of str to str, optional
            Units of the signals; those that are not named have none.
        fs : float, optional
            Sampling rate, Hz, with the time `start` of the first value; or
        time : array_like, optional
            Times, s, shape (points,), rising; or
        frequency : array_like, optional
            Frequencies, Hz, shape (points,), rising.
        start : float
            Time of the first value, s.
        source : str
            Where the recording comes from.

        Examples
        --------
        >>> import microslip, numpy as np
        >>> recording = microslip.Recording.of(
        ...     {"acc1": np.sin(np.arange(100))}, {"acc1": "g"}, fs=1000.0)
        >>> recording["acc1"].unit, round(float(recording["acc1"].values[1]), 4)
        ('m/s^2', 8.252)
        """
        if not isinstance(signals, Mapping) or not signals:
            raise InputError(f"signals = {signals!r}; must be a mapping of names to arrays")
        named = {} if units is None else units
        if not isinstance(named, Mapping):
            raise InputError(f"units = {units!r}; must be a mapping of names to units")
        for name in named:
            if name not in signals:
                raise InputError(f"units has {name!r}; must name signals: {', '.join(signals)}")
        channels = [Channel(name, values, named.get(name)) for name, values in signals.items()]
        return cls(channels, _axis_of(fs, time, frequency, start), source)

    @classmethod
    def _of(cls, found: Mapping[str, Any]) -> Recording:
        unit, start, step, values = found["axis"]
        axis = object.__new__(Axis)
        for name, value in (("values", values), ("step", step), ("start", start), ("unit", unit),
                            ("_count", None)):  # fmt: skip
            object.__setattr__(axis, name, value)
        channels = tuple(
            Channel(name, numbers, of, attributes(more, "attributes"))
            for name, of, numbers, more in found["channels"]
        )
        recording = object.__new__(cls)
        for name, value in (("channels", channels), ("axis", axis), ("source", found["source"]),
                            ("attributes", attributes(found["attributes"], "attributes"))):  # fmt: skip
            object.__setattr__(recording, name, value)
        return recording

    def __len__(self) -> int:
        return len(np.asarray(self.channels[0].values))

    def __getitem__(self, name: str) -> Channel:
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise KeyError(f"{name!r}; {self.source} has {', '.join(c.name for c in self.channels)}")

    @property
    def fs(self) -> float:
        """Sampling rate, Hz, of evenly spaced times."""
        if self.axis.unit != "s" or not self.axis.even:
            raise InputError(f"{self.source} has no sampling rate; it must be evenly spaced in time")
        return 1.0 / self.axis.step

    @property
    def time(self) -> RealArray:
        """s, shape (points,)."""
        return self._points("s", "time")

    @property
    def frequency(self) -> RealArray:
        """Hz, shape (points,)."""
        return self._points("Hz", "frequency")

    def to_sep5(self) -> list[dict[str, Any]]:
        """Dictionaries of SEP 5 of SDyPy, one per channel: ``data``, ``name``, ``unit_str``, ``fs``
        or ``time``, ``channel_name``, ``quantity``; ``start`` where the first time is not 0.

        Raises
        ------
        ValueError
            Where the recording is not over time.
        """
        if self.axis.unit != "s":
            raise InputError(f"{self.source} is over {self.axis.unit}; must be over time for SEP 5")
        over: dict[str, Any] = {"time": self.time}
        if self.axis.even:
            over = {"fs": self.fs}
            if self.axis.start != 0.0:
                over["start"] = self.axis.start
        return [
            {"data": channel.values, "name": channel.name, "channel_name": channel.name,
             "unit_str": channel.unit or "", "quantity": _quantity(channel), "source": self.source,
             **over}
            for channel in self.channels
        ]  # fmt: skip

    @classmethod
    def from_sep5(cls, signals: Union[Mapping[str, Any], Sequence[Mapping[str, Any]]], *,
                  source: Optional[str] = None) -> Recording:  # fmt: skip
        """A recording from dictionaries of SEP 5, one per channel, all over the same times.

        Parameters
        ----------
        signals : mapping or sequence of mapping
            With ``data``, ``name`` (or ``channel_name``), ``unit_str`` and ``fs`` or ``time``. An
            empty ``unit_str``: unit not known.
        source : str, optional
            Where the recording comes from; by default the source of the first.

        Raises
        ------
        ValueError
            Where a key is missing, a unit is unknown or times differ; the message names the key.
        """
        given = [signals] if isinstance(signals, Mapping) else sequence(signals, "signals", "mappings")
        if not given:
            raise InputError("signals is empty; must have at least one mapping")
        channels = []
        axis: Optional[Axis] = None
        for i, signal in enumerate(given):
            if not isinstance(signal, Mapping):
                raise InputError(f"signals[{i}] = {type(signal).__name__}; must be a mapping")
            channels.append(_sep5_channel(signal, f"signals[{i}]"))
            other = _axis_of(signal.get("fs"), signal.get("time"), None, signal.get("start", 0.0),
                             f"signals[{i}]: ")  # fmt: skip
            if axis is not None and not _same_axis(axis, other):
                raise InputError(f"signals[{i}] has other times than the first; must have the same")
            axis = other if axis is None else axis
        assert axis is not None
        first = given[0].get("source")
        named = source if source is not None else first if isinstance(first, str) and first else "SEP 5"
        return cls(channels, axis, named)

    def to_uff(self) -> list[dict[str, Any]]:
        """Dictionaries of datasets 58 as in pyuff, one per channel; ``x`` has all abscissae."""
        functions = _core.functions_of_recording(self._dict())
        points = self.axis.points(len(self))
        for function in functions:
            function["x"] = points
            empty = [key for key, value in function.items() if isinstance(value, str) and not value]
            function.update(dict.fromkeys(empty, "NONE"))
        return functions

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with one column per channel, over the axis."""
        import pandas

        name = {"s": "time [s]", "Hz": "frequency [Hz]"}.get(self.axis.unit, f"[{self.axis.unit}]")
        index = pandas.Index(self.axis.points(len(self)), name=name)
        columns = {c.name if c.unit is None else f"{c.name} [{c.unit}]": c.values
                   for c in self.channels}  # fmt: skip
        return pandas.DataFrame(columns, index=index)

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the channels over the axis, by matplotlib; of complex ones the magnitude."""
        signals = [(c.name, c.unit or "", np.asarray(c.values)) for c in self.channels]
        return plot_signals(ax, style, self.axis.points(len(self)), self.axis.unit, signals)

    def _points(self, unit: str, what: str) -> RealArray:
        if self.axis.unit != unit:
            raise InputError(f"{self.source} is over {self.axis.unit}; must be over {what}")
        return self.axis.points(len(self))

    def _dict(self) -> dict[str, Any]:
        axis = self.axis
        channels = [(c.name, c.unit, c.values, list(attributes(c.attributes, "attributes")))
                    for c in self.channels]  # fmt: skip
        return {"source": self.source, "axis": (axis.unit, axis.start, axis.step, axis.values),
                "channels": channels,
                "attributes": list(attributes(self.attributes, "attributes"))}  # fmt: skip

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        points = self.axis.points(len(self))
        rows = [("source", self.source), ("points", str(len(self))),
                ("axis", f"{si(points[0], '1')} to {si(points[-1], self.axis.unit)}")]  # fmt: skip
        if self.axis.even and self.axis.unit == "s":
            rows.append(("rate", si(self.fs, "Hz")))
        for channel in self.channels:
            largest = float(np.abs(np.asarray(channel.values)).max())
            rows.append((channel.name, f"up to {si(largest, channel.unit or '1')}"))
        return "Recording", rows


def _axis_of(fs: Any, time: Any, frequency: Any, start: Any, at: str = "") -> Axis:
    given = [name for name, value in (("fs", fs), ("time", time), ("frequency", frequency))
             if value is not None]  # fmt: skip
    if len(given) != 1:
        raise InputError(f"{at}{' and '.join(given) or 'neither fs nor time'} given; must be one of"
                         " them")  # fmt: skip
    if fs is not None:
        return Axis(step=1.0 / positive(fs, f"{at}fs"), start=real(start, f"{at}start"))
    values = time if frequency is None else frequency
    return Axis(real_array(values, f"{at}{given[0]}"), unit="s" if frequency is None else "Hz")


def _same_axis(a: Axis, b: Axis) -> bool:
    if a.values is None or b.values is None:
        return a.values is b.values and (a.start, a.step) == (b.start, b.step)
    return bool(np.array_equal(np.asarray(a.values), np.asarray(b.values)))


def _sep5_channel(signal: Mapping[str, Any], at: str) -> Channel:
    if "data" not in signal:
        raise InputError(f"{at}: data is missing; must be an array")
    name = signal.get("name", signal.get("channel_name"))
    if "unit_str" not in signal:
        raise InputError(f"{at}: unit_str is missing; must be a unit, or empty where none is known")
    unit = signal["unit_str"]
    if unit is not None and not isinstance(unit, str):
        raise InputError(f"{at}: unit_str = {unit!r}; must be a text")
    quantity = signal.get("quantity")
    more = [("quantity", quantity)] if isinstance(quantity, str) and quantity else []
    return Channel(text(name, f"{at}: name"), signal["data"], unit or None, tuple(more))


_QUANTITIES = {"m": "displacement", "m/s": "velocity", "m/s^2": "acceleration", "N": "force"}


def _quantity(channel: Channel) -> str:
    quantity: str = dict(attributes(channel.attributes, "attributes")).get("quantity", "")
    return quantity or _QUANTITIES.get(channel.unit or "", "")


def _assumed(assume_units: object) -> list[str]:
    if assume_units is None:
        return []
    if isinstance(assume_units, str):
        return [assume_units]
    if isinstance(assume_units, Mapping):
        return [f"{text(name, 'a name in assume_units')}={text(unit, f'assume_units[{name!r}]')}"
                for name, unit in assume_units.items()]  # fmt: skip
    given = sequence(assume_units, "assume_units", "texts, or a mapping of names to units")
    return [text(one, f"assume_units[{i}]") for i, one in enumerate(given)]


def read_recordings(
    path: Path,
    *,
    assume_units: Union[None, str, Mapping[str, str], Sequence[str]] = None,
    allow_truncated: bool = False,
    rate: Optional[float] = None,
    progress: Optional[Progress] = None,
) -> list[Recording]:
    """Reads the recordings of a file, by its content: CSV, universal file (58, 58b), MATLAB, HDF5.

    Parameters
    ----------
    path : path
        ``FILE.mat:VARIABLE`` for a part of a MATLAB file.
    assume_units : mapping, "SI" or sequence of str, optional
        Units of channels, and of time, for which the file gives none: ``{"acc1": "g", "time":
        "ms"}``. "SI": for all channels whose name states the quantity. A sequence as on the command
        line: ``["SI", "acc1=g"]``.
    allow_truncated : bool
        Whether to accept a file that ends before all data that it announces.
    rate : float, optional
        Sampling rate, Hz, for a file in which nothing gives times or a rate.
    progress : callable, optional
        Called with (bytes done, bytes); False cancels.

    Returns
    -------
    list of Recording
        Channels that share an axis are one recording. Faults that the reader tolerated are issued
        as `MicroslipWarning` and kept as an attribute ``warning`` of each recording.

    Raises
    ------
    FileError, FormatError
        Where the file cannot be read.
    ValueError
        Where a unit of `assume_units` is unknown or does not fit; where the file has times or a
        rate and `rate` is given.
    """
    found, warnings = _core.read_recordings(
        path_of(path, "path"),
        _assumed(assume_units),
        flag(allow_truncated, "allow_truncated"),
        None if rate is None else real(rate, "rate"),
        progress_of(progress),
    )
    warn_of(warnings)
    return [Recording._of(recording) for recording in found]


def write_recordings(path: Path, recordings: Union[Recording, Sequence[Recording]],
                     format: Optional[str] = None, *, replace: bool = False) -> None:  # fmt: skip
    """Writes recordings: at once and whole, or not at all.

    Parameters
    ----------
    path : path
        Its extension gives the format: .csv; .uff .unv .uf (58b); .mat; .h5 .hdf5.
    recordings : Recording or sequence of Recording
        One only for CSV.
    format : {"csv", "uff", "uff-ascii", "mat", "h5"}, optional
        Format, whatever the extension.
    replace : bool
        Whether an existing recording of this format is replaced. Otherwise one of another content
        is left as it is.

    Raises
    ------
    FileError
        Where the file cannot be written, or a file exists that must not be replaced.
    ValueError
        Where the format cannot store the recordings.
    """
    name = path_of(path, "path")
    as_format = None if format is None else one_of(format, "format", FORMATS)
    _core.write_recordings(name, [r._dict() for r in recordings_of(recordings)], as_format,
                           flag(replace, "replace"))  # fmt: skip


def recordings_of(value: object, name: str = "recordings") -> list[Recording]:
    """One recording, or several."""
    given = [value] if isinstance(value, Recording) else sequence(value, name, "microslip.Recording")
    if not given:
        raise InputError(f"{name} is empty; must have at least one recording")
    for i, recording in enumerate(given):
        if not isinstance(recording, Recording):
            raise InputError(f"{name}[{i}] = {type(recording).__name__}; must be a"
                             " microslip.Recording")  # fmt: skip
    return list(given)
