# SPDX-License-Identifier: MIT
"""Time marching under any forces."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

from . import _core
from ._arguments import (
    ArrayLike,
    Progress,
    RealArray,
    flag,
    mapping,
    names,
    not_negative,
    one_of,
    optional_array,
    positive,
    real_array,
    shown,
    whole,
)
from ._arguments import progress as progress_of
from ._errors import InputError
from ._plot import plot_march
from ._results import Note, Shown, Summary, notes, outcome, reported, si, summary_of
from ._structure import Structure

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes


class PointMotion(NamedTuple):
    """The motion of a point relative to its base, one value per recorded time."""

    displacement: RealArray  #: m
    velocity: RealArray  #: m/s
    acceleration: RealArray  #: m/s**2


class JointMotion(NamedTuple):
    """The motion of a joint, one value per recorded time."""

    displacement: RealArray  #: m, between the ends of the joint
    force: RealArray  #: N, the restoring force


@dataclass(frozen=True)
class MarchEnergy:
    """Energy balance of a march, J.

    Attributes
    ----------
    initial, input, linear_dissipation, kinetic, elastic, joint_dissipation, joint_stored, joint_linear_dissipation : float
        Each computed by itself, none as the remainder of the others.
    imbalance : float
        Residual of the balance, relative, 1: it measures the error of the integration.
    """

    initial: float
    input: float
    linear_dissipation: float
    kinetic: float
    elastic: float
    joint_dissipation: float
    joint_stored: float
    joint_linear_dissipation: float
    imbalance: float


@dataclass(frozen=True, repr=False, eq=False)
class MarchResult(Shown):
    """Result of `march`.

    Attributes
    ----------
    time : ndarray
        Recorded times, s, shape (n,).
    points : dict of str to PointMotion
        Motion of each requested point.
    joints : dict of str to JointMotion
        Motion of each joint.
    reached : float
        The last time that was reached, s.
    steps : int
        Number of steps.
    error_estimate : float or None
        Estimated error of the displacement, relative to its largest value, 1; None where it was not
        requested.
    energy : MarchEnergy
        Energy balance.
    warnings : tuple of Note
        Warnings that concern the result.
    summary : Summary
        How the march ended.
    """

    time: RealArray
    points: dict[str, PointMotion]
    joints: dict[str, JointMotion]
    reached: float
    steps: int
    error_estimate: Optional[float]
    energy: MarchEnergy
    warnings: tuple[Note, ...]
    summary: Summary

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the motions of points, ``"displacement_tip [m]"``, and of joints,
        ``"lap displacement [m]"``."""
        import pandas

        columns = {"time [s]": self.time}
        for name, motion in self.points.items():
            columns[f"displacement_{name} [m]"] = motion.displacement
            columns[f"velocity_{name} [m/s]"] = motion.velocity
            columns[f"acceleration_{name} [m/s^2]"] = motion.acceleration
        for name, joint in self.joints.items():
            columns[f"{name} displacement [m]"] = joint.displacement
            columns[f"{name} force [N]"] = joint.force
        return pandas.DataFrame(columns)

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws the displacements over time, by matplotlib."""
        displacements = {name: motion.displacement for name, motion in self.points.items()}
        return plot_march(ax, style, self.time, displacements)

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("reached", si(self.reached, "s")), ("steps", str(self.steps))]
        if self.error_estimate is not None:
            rows.append(("estimated error", f"{self.error_estimate:.2g}"))
        rows.append(("energy imbalance", f"{self.energy.imbalance:.2g}"))
        for name, motion in self.points.items():
            rows.append((name, f"max |w| = {si(abs(motion.displacement).max(), 'm')}"))
        return "March", rows + outcome(self)


def march(
    structure: Structure,
    time: ArrayLike,
    forces: Optional[Mapping[str, ArrayLike]] = None,
    *,
    points: Optional[Sequence[str]] = None,
    normal_loads: Optional[Mapping[str, ArrayLike]] = None,
    law: str = "incremental",
    displacement: Optional[ArrayLike] = None,
    velocity: Optional[ArrayLike] = None,
    step: float = 0.0,
    every: int = 1,
    tolerance: float = 1e-8,
    max_iterations: int = 50,
    largest_imbalance: float = 1e-4,
    estimate_error: bool = True,
    largest_error: float = 1e-2,
    elements: int = 1000,
    progress: Optional[Progress] = None,
    strict: bool = True,
) -> MarchResult:
    """Marches a structure in time, with the exact memory of its joints as state.

    Parameters
    ----------
    structure : Structure
        The structure. Its periodic excitation does not act; its static loads do.
    time : array_like
        Times, s, shape (n,); two at least, rising.
    forces : mapping of str to array_like, optional
        Forces at points, N, or accelerations of bases, m/s**2; shape (n,), linear between the
        times. None: free vibration.
    points : sequence of str, optional
        Points whose motion is recorded; by default all.
    normal_loads : mapping of str to array_like, optional
        P_N/P_0 of joints, 1, shape (n,); 0 or more.
    law : {"incremental", "total"}
        How the force of stuck elements follows a change of the load.
    displacement, velocity : array_like, optional
        Modal, at the first time: q, kg**0.5 m, and its rate, kg**0.5 m/s, shape (modes,).
    step : float
        Longest step, s; 0: chosen by the structure.
    every : int
        Every `every`-th time is recorded.
    tolerance, max_iterations, largest_imbalance, estimate_error, largest_error, elements
        As of ``microslip march`` and microslip::MarchOptions.
    progress : callable, optional
        Called with (done, total); False cancels.
    strict : bool
        Whether to raise where the march does not converge; otherwise a warning is issued.

    Returns
    -------
    MarchResult

    Raises
    ------
    ValueError, NotConverged
    """
    strict = flag(strict, "strict")
    acting = march_arguments(
        structure, time, forces, points=points, normal_loads=normal_loads, law=law,
        displacement=displacement, velocity=velocity, step=step, every=every, tolerance=tolerance,
        max_iterations=max_iterations, largest_imbalance=largest_imbalance,
        estimate_error=estimate_error, largest_error=largest_error, elements=elements,
    )  # fmt: skip
    found = _core.march(structure._core, *acting, progress_of(progress))
    result = MarchResult(
        time=found["time"],
        points={name: PointMotion(*motion) for name, *motion in found["points"]},
        joints={name: JointMotion(*motion) for name, *motion in found["joints"]},
        reached=found["reached"],
        steps=found["steps"],
        error_estimate=found["error_estimate"],
        energy=MarchEnergy(**found["energy"]),
        warnings=notes(found["warnings"]),
        summary=summary_of(found["summary"]),
    )
    return reported(result, strict)


#: Times, forces, normal loads and options as the compiled half takes them.
_Acting = tuple[
    RealArray, list[tuple[str, RealArray]], list[tuple[str, RealArray, str]], dict[str, Any]
]


def _named(value: object, name: str) -> Mapping[str, Any]:
    return mapping({} if value is None else value, name)


def march_arguments(
    structure: object,
    time: object,
    forces: object = None,
    *,
    points: Optional[Sequence[str]] = None,
    normal_loads: object = None,
    law: object = "incremental",
    displacement: object = None,
    velocity: object = None,
    step: object = 0.0,
    every: object = 1,
    tolerance: object = 1e-8,
    max_iterations: object = 50,
    largest_imbalance: object = 1e-4,
    estimate_error: object = True,
    largest_error: object = 1e-2,
    elements: object = 1000,
) -> _Acting:
    """The arguments of `march`, checked."""
    if not isinstance(structure, Structure):
        raise InputError(f"structure = {shown(structure)}; must be a microslip.Structure")
    times = real_array(time, "time")
    count = len(times)
    modes = len(structure.angular_frequency)
    rule = one_of(law, "law", ("incremental", "total"))
    acting = [(name, real_array(f, f"forces[{name!r}]", length=count, per="one per time"))
              for name, f in _named(forces, "forces").items()]  # fmt: skip
    loads = [(name, real_array(p, f"normal_loads[{name!r}]", length=count, per="one per time"), rule)
             for name, p in _named(normal_loads, "normal_loads").items()]  # fmt: skip
    recorded = list(structure.points) if points is None else names(points, "points")
    options = {
        "step": not_negative(step, "step"),
        "every": whole(every, "every", 1),
        "points": recorded,
        "displacement": optional_array(displacement, "displacement", modes, "one per mode"),
        "velocity": optional_array(velocity, "velocity", modes, "one per mode"),
        "tolerance": positive(tolerance, "tolerance"),
        "max_iterations": whole(max_iterations, "max_iterations", 1),
        "largest_imbalance": positive(largest_imbalance, "largest_imbalance"),
        "estimate_error": flag(estimate_error, "estimate_error"),
        "largest_error": positive(largest_error, "largest_error"),
        "elements": whole(elements, "elements", 1, 1_000_000),
    }
    return times, acting, loads, options
