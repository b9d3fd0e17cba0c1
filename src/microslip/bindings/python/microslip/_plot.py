# SPDX-License-Identifier: MIT
"""Pictures, by matplotlib, which is needed for them alone."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from ._errors import Error

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._calibration import CalibratedJoint
    from ._identification import Identification
    from ._joint import Joint
    from ._levels import Levels
    from ._march import MarchResult
    from ._recordings import Recording
    from ._ring_down import RingDown
    from ._vibration import ResponseCurve


def _axes(ax: Optional[Axes], x: str, y: str) -> Axes:
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError:
            raise Error("matplotlib is missing; pictures need it. Debian: python3-matplotlib") from None
        ax = pyplot.subplots(layout="constrained")[1]
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    ax.grid(True, which="major", alpha=0.3, linewidth=0.6)
    return ax


def plot_density(joint: Joint, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The density of a joint, its atoms as stems on an axis of their own scale."""
    ax = _axes(ax, "slip force [N]", "density [1/N]")
    largest = joint._core.largest_slip_force or 1.0
    force = np.linspace(0.0, 1.05 * largest, 2001)[1:]
    ax.plot(force, joint.density_at(force), **style)
    ax.set_ylim(bottom=0.0)
    ax.set_xlim(0.0, 1.05 * largest)
    _draw_atoms(joint, ax)
    return ax


def _draw_atoms(joint: Joint, ax: Axes) -> None:
    atoms = [part for part in joint._core.parts() if part[0] == "atoms"]
    if not atoms:
        return
    weights = ax.twinx()
    weights.set_ylabel("weight of atoms [1]")
    for part in atoms:
        weights.stem(part[1], part[2], linefmt="C1-", markerfmt="C1o", basefmt=" ")
    weights.set_ylim(bottom=0.0)


def plot_identification(found: Union[Identification, CalibratedJoint], ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The identified density with its band, and where the levels tell of it."""
    ax = _axes(ax, "slip force [N]", "density [1/N]")
    (line,) = ax.plot(found.slip_force, found.density, **{"label": "identified", **style})
    if found.lower is not None:
        ax.fill_between(found.slip_force, found.lower, found.upper, alpha=0.25, linewidth=0,
                        color=line.get_color(), label="95 % of the draws")  # fmt: skip
    ax.axvspan(0.0, found.covered_from, color="0.5", alpha=0.12, linewidth=0,
               label="below the lowest level")  # fmt: skip
    ax.set_ylim(bottom=0.0)
    largest = found.joint._core.largest_slip_force
    ax.set_xlim(0.0, max(found.slip_force[-1], found.covered_to, 1.05 * largest))
    _draw_atoms(found.joint, ax)
    ax.legend(frameon=False)
    return ax


def plot_levels(levels: Levels, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """D over A, with standard deviations where they are known."""
    ax = _axes(ax, "amplitude [m]", "dissipation per cycle [J]")
    style.setdefault("fmt", "o")
    style.setdefault("markersize", 4)
    style.setdefault("yerr", levels.dissipation_std)
    style.setdefault("xerr", levels.amplitude_std)
    ax.errorbar(levels.amplitude, levels.dissipation, **style)
    ax.set_xscale("log")
    ax.set_yscale("log")
    return ax


def plot_curve(curve: ResponseCurve, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The response over the frequency, with its peaks."""
    ax = _axes(ax, "frequency [Hz]", f"{curve._kind} [{curve.unit}]")
    (line,) = ax.plot(curve.frequency, curve.response, **style)
    _draw_band(curve, ax, line)
    ax.plot(curve.peaks.frequency, curve.peaks.response, "o", color=line.get_color(), markersize=4)
    return ax


def _draw_band(curve: ResponseCurve, ax: Axes, line: Any) -> None:
    from ._vibration import ResponseBand

    if isinstance(curve, ResponseBand) and not curve._of_force:
        ax.fill_between(curve.frequency, curve.lower, curve.upper, alpha=0.25, linewidth=0,
                        color=line.get_color())  # fmt: skip


def plot_march(result: MarchResult, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The displacements of all recorded points over time."""
    ax = _axes(ax, "time [s]", "displacement [m]")
    for name, motion in result.points.items():
        ax.plot(result.time, motion.displacement, **{"label": name, **style})
    if result.points:
        ax.legend(frameon=False)
    return ax


def plot_recording(recording: Recording, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The channels over the axis; of complex ones the magnitude."""
    units = {channel.unit or "" for channel in recording.channels}
    what = {"s": "time [s]", "Hz": "frequency [Hz]"}.get(recording.axis.unit, recording.axis.unit)
    ax = _axes(ax, what, f"[{units.pop()}]" if len(units) == 1 else "in SI")
    points = recording.axis.points(len(recording))
    for channel in recording.channels:
        values = np.asarray(channel.values)
        ax.plot(points, np.abs(values) if np.iscomplexobj(values) else values,
                **{"label": channel.name, **style})  # fmt: skip
    ax.legend(frameon=False)
    return ax


def plot_ring_down(decay: RingDown, ax: Optional[Axes] = None, **style: Any) -> Axes:
    """The damping ratio over the amplitude, with standard deviations."""
    ax = _axes(ax, "amplitude [m]", "damping ratio [1]")
    style.setdefault("fmt", "o")
    style.setdefault("markersize", 3)
    style.setdefault("yerr", decay.damping_ratio_std)
    ax.errorbar(decay.amplitude, decay.damping_ratio, **style)
    ax.set_xscale("log")
    ax.set_ylim(bottom=0.0)
    return ax
