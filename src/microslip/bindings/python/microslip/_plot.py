# SPDX-License-Identifier: MIT
"""Plots of arrays by matplotlib, which is needed for them alone.

Each function draws on `ax`, or on a new figure where that is None; `style` holds the keywords that
users give for the lines.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
import numpy.typing as npt

from ._arguments import RealArray
from ._errors import Error

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Style = Mapping[str, Any]
#: Lower and upper end at each point of a curve.
Band = tuple[RealArray, RealArray]
#: Slip forces, N, and weights, 1.
Atoms = tuple[RealArray, RealArray]


def _axes(ax: Optional[Axes], x: str, y: str) -> Axes:
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError:
            raise Error("matplotlib is missing; plots need it. Debian: python3-matplotlib") from None
        ax = pyplot.subplots(layout="constrained")[1]
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    ax.grid(True, which="major", alpha=0.3, linewidth=0.6)
    return ax


def _draw_band(ax: Axes, x: RealArray, band: Optional[Band], line: Any, **style: Any) -> None:
    if band is not None:
        ax.fill_between(x, *band, alpha=0.25, linewidth=0, color=line.get_color(), **style)


def _draw_atoms(ax: Axes, atoms: Sequence[Atoms]) -> None:
    """Stems on an axis of their own scale."""
    if not atoms:
        return
    weights = ax.twinx()
    weights.set_ylabel("weight of atoms [1]")
    for slip_force, weight in atoms:
        weights.stem(slip_force, weight, linefmt="C1-", markerfmt="C1o", basefmt=" ")
    weights.set_ylim(bottom=0.0)


def plot_density(ax: Optional[Axes], style: Style, slip_force: RealArray, density: RealArray,
                 atoms: Sequence[Atoms]) -> Axes:  # fmt: skip
    """A density with its atoms, N and 1/N, up to the last slip force."""
    ax = _axes(ax, "slip force [N]", "density [1/N]")
    ax.plot(slip_force, density, **style)
    ax.set_ylim(bottom=0.0)
    ax.set_xlim(0.0, slip_force[-1])
    _draw_atoms(ax, atoms)
    return ax


def plot_identification(ax: Optional[Axes], style: Style, slip_force: RealArray, density: RealArray,
                        atoms: Sequence[Atoms], *, band: Optional[Band], covered_from: float,
                        up_to: float) -> Axes:  # fmt: skip
    """An identified density with its band, and the slip force from which the levels determine it.
    The axis reaches `up_to` at least."""
    ax = _axes(ax, "slip force [N]", "density [1/N]")
    (line,) = ax.plot(slip_force, density, **{"label": "identified", **style})
    _draw_band(ax, slip_force, band, line, label="95 % of the draws")
    ax.axvspan(0.0, covered_from, color="0.5", alpha=0.12, linewidth=0,
               label="below the lowest level")  # fmt: skip
    ax.set_ylim(bottom=0.0)
    ax.set_xlim(0.0, max(slip_force[-1], up_to))
    _draw_atoms(ax, atoms)
    ax.legend(frameon=False)
    return ax


def plot_levels(ax: Optional[Axes], style: Style, amplitude: RealArray, dissipation: RealArray,
                amplitude_std: Optional[RealArray],
                dissipation_std: Optional[RealArray]) -> Axes:  # fmt: skip
    """D over A, with standard deviations where they are known."""
    ax = _axes(ax, "amplitude [m]", "dissipation per cycle [J]")
    deviations = {"xerr": amplitude_std, "yerr": dissipation_std}
    ax.errorbar(amplitude, dissipation, **{"fmt": "o", "markersize": 4, **deviations, **style})
    ax.set_xscale("log")
    ax.set_yscale("log")
    return ax


def plot_curve(ax: Optional[Axes], style: Style, frequency: RealArray, response: RealArray,
               label: str, *, peaks: tuple[RealArray, RealArray],
               band: Optional[Band]) -> Axes:  # fmt: skip
    """A response over the frequency, with its peaks."""
    ax = _axes(ax, "frequency [Hz]", label)
    (line,) = ax.plot(frequency, response, **style)
    _draw_band(ax, frequency, band, line)
    ax.plot(*peaks, "o", color=line.get_color(), markersize=4)
    return ax


def plot_march(ax: Optional[Axes], style: Style, time: RealArray,
               displacements: Mapping[str, RealArray]) -> Axes:  # fmt: skip
    """Displacements of points by name over time."""
    ax = _axes(ax, "time [s]", "displacement [m]")
    for name, displacement in displacements.items():
        ax.plot(time, displacement, **{"label": name, **style})
    if displacements:
        ax.legend(frameon=False)
    return ax


def plot_signals(ax: Optional[Axes], style: Style, points: RealArray, unit: str,
                 signals: Sequence[tuple[str, str, npt.NDArray[Any]]]) -> Axes:  # fmt: skip
    """Signals of a name and a unit over points of an axis; of complex ones the magnitude."""
    units = {of for _, of, _ in signals}
    over = {"s": "time [s]", "Hz": "frequency [Hz]"}.get(unit, unit)
    ax = _axes(ax, over, f"[{units.pop()}]" if len(units) == 1 else "in SI")
    for name, _, values in signals:
        ax.plot(points, np.abs(values) if np.iscomplexobj(values) else values,
                **{"label": name, **style})  # fmt: skip
    ax.legend(frameon=False)
    return ax


def plot_ring_down(ax: Optional[Axes], style: Style, amplitude: RealArray, damping_ratio: RealArray,
                   damping_ratio_std: RealArray) -> Axes:  # fmt: skip
    """The damping ratio over the amplitude, with standard deviations."""
    ax = _axes(ax, "amplitude [m]", "damping ratio [1]")
    ax.errorbar(amplitude, damping_ratio,
                **{"fmt": "o", "markersize": 3, "yerr": damping_ratio_std, **style})  # fmt: skip
    ax.set_xscale("log")
    ax.set_ylim(bottom=0.0)
    return ax
