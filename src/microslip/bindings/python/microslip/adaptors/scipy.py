# SPDX-License-Identifier: MIT
"""Time integration of structures with joints by `scipy.integrate.solve_ivp`.

A joint has a memory: its force is not a function of the state (x, x'). Between two reversals of its
displacement it is, ``memory.trial(u)``, with the memory as it was at the last reversal. So one
integrates up to a reversal, which is an event, takes the step there with ``memory.advance(u)``, and
goes on with a new call. `solve_jointed` does that for M x'' + C x' + K x + joint forces = f(t). For
equations of another form this is the pattern, with one joint:

>>> import numpy as np
>>> import microslip
>>> from scipy.integrate import solve_ivp
>>> memory = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)]).memory()
>>> def slope(t, y):
...     return [y[1], np.sin(100 * t) - 20 * y[1] - memory.trial(y[0]).force]
>>> def turns(t, y):
...     return y[1]
>>> turns.terminal = True
>>> t, y, pieces = 0.0, [0.0, 1e-12], 0
>>> turns.direction = -1                       # it moves upwards first, and turns down next
>>> while t < 0.2:
...     piece = solve_ivp(slope, (t, 0.2), y, method="DOP853", events=turns, rtol=1e-9, atol=1e-12)
...     t, y, pieces = piece.t[-1], piece.y[:, -1], pieces + 1
...     force = memory.advance(y[0])           # the reversal is remembered
...     turns.direction = -turns.direction     # the next is the other way round
>>> pieces
7
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np

from .._arguments import (
    ArrayLike,
    RealArray,
    optional_array,
    positive,
    real_array,
    sequence,
    shown,
    text,
)
from .._errors import Error, InputError
from .._joint import Joint, Memory
from .._results import Shown, si


class JointPath(NamedTuple):
    """Displacement and force of a joint over time."""

    displacement: RealArray  #: m, one per time
    force: RealArray  #: N, one per time
    reversals: RealArray  #: times of its reversals, s
    memory: Memory  #: memory after the last time


@dataclass(frozen=True, repr=False, eq=False)
class JointedSolution(Shown):
    """The motion of a structure.

    Attributes
    ----------
    time : ndarray
        s, shape (n,).
    displacement, velocity : ndarray
        m and m/s, shape (dofs, n).
    joints : tuple of JointPath
        In the order given.
    evaluations : int
        Number of evaluations of the accelerations.
    """

    time: RealArray
    displacement: RealArray
    velocity: RealArray
    joints: tuple[JointPath, ...]
    evaluations: int

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("time", f"{si(self.time[0], '1')} to {si(self.time[-1], 's')}"),
                ("evaluations", str(self.evaluations))]  # fmt: skip
        rows.extend(
            (f"joint {j}", f"max |u| = {si(abs(path.displacement).max(), 'm')},"
             f" {len(path.reversals)} reversals")
            for j, path in enumerate(self.joints)
        )  # fmt: skip
        return "Jointed solution", rows


def solve_jointed(
    mass: ArrayLike,
    damping: ArrayLike,
    stiffness: ArrayLike,
    joints: Sequence[tuple[Joint, ArrayLike]],
    force: Optional[Callable[[float], Any]],
    t_span: tuple[float, float],
    *,
    displacement: Optional[ArrayLike] = None,
    velocity: Optional[ArrayLike] = None,
    t_eval: Optional[ArrayLike] = None,
    method: str = "DOP853",
    rtol: float = 1e-8,
    atol: Optional[float] = None,
    max_step: Optional[float] = None,
) -> JointedSolution:
    """Solves M x'' + C x' + K x + sum_j psi_j F_j(psi_j' x) = f(t), with exact memory.

    Parameters
    ----------
    mass, damping, stiffness : array_like
        M [kg], C [N s/m], K [N/m], shape (dofs, dofs), or (dofs,) where they are diagonal; K
        without the joints.
    joints : sequence of (Joint, array_like)
        Each with psi_j, shape (dofs,): its displacement is u = psi_j' x. Virgin at u = 0.
    force : callable or None
        f(t), N, shape (dofs,); smooth, or `max_step` must be short enough to resolve it.
    t_span : (float, float)
        First and last time, s, rising.
    displacement, velocity : array_like, optional
        x [m] and x' [m/s] at the beginning, shape (dofs,); by default at rest at 0.
    t_eval : array_like, optional
        Times of the result, s, in `t_span`, rising; by default those of the steps.
    method : str
        Method of `scipy.integrate.solve_ivp`.
    rtol : float
        Relative tolerance of a step.
    atol : float, optional
        Absolute tolerance, in the units of x and x'. By default rtol*1e-3 times the largest motion
        of the stuck structure, due to its initial state or f at 200 times.
    max_step : float, optional
        Longest step, s. Two reversals of a joint within a step are missed. By default a tenth of
        the shortest period of the stuck structure.

    Returns
    -------
    JointedSolution

    Raises
    ------
    ValueError
        Where shapes do not fit, or M is not positive definite.
    Error
        Where `solve_ivp` fails, with its message.
    """
    parts = _joints(joints)
    system = _System(mass, damping, stiffness, parts, force)
    begin, end = real_array(t_span, "t_span", length=2, per="where it begins and ends").tolist()
    if not begin < end:
        raise InputError(f"t_span = {(begin, end)}; must rise")
    times = None if t_eval is None else real_array(t_eval, "t_eval")
    if times is not None and (
        times[0] < begin or times[-1] > end or np.any(np.diff(times) <= 0.0)
    ):
        raise InputError(f"t_eval must rise, within {begin} and {end}")
    n = system.dofs
    start = np.zeros(2 * n)
    for value, name, half in (
        (displacement, "displacement", slice(0, n)),
        (velocity, "velocity", slice(n, 2 * n)),
    ):
        given = optional_array(value, name, n, "one per degree of freedom")
        start[half] = 0.0 if given is None else given
    options = {
        "method": text(method, "method"),
        "rtol": positive(rtol, "rtol"),
        "atol": system.resolution(start, begin, end) * rtol if atol is None else positive(atol, "atol"),
        "max_step": 0.1 * system.shortest_period if max_step is None else positive(max_step, "max_step"),
    }  # fmt: skip
    return _solve(system, start, begin, end, times, options)


def _joints(joints: object) -> list[tuple[Joint, Any]]:
    parts = []
    for j, pair in enumerate(sequence(joints, "joints", "pairs of a Joint and its shape")):
        try:
            joint, shape = pair
        except (TypeError, ValueError):
            joint = shape = None
        if not isinstance(joint, Joint):
            raise InputError(f"joints[{j}] = {shown(pair)}; must be a pair of a microslip.Joint and its"
                             " shape")  # fmt: skip
        parts.append((joint, shape))
    return parts


def _matrix(value: object, name: str, dofs: Optional[int]) -> RealArray:
    array = real_array(value, name, ndim=None)
    if array.ndim == 1:
        array = np.diag(array)
    size = len(array) if dofs is None and array.ndim == 2 else dofs
    if array.shape != (size, size):
        raise InputError(f"{name} has the shape {array.shape}; must be square, as M is")
    return array


class _Joint:
    """A joint of a structure in motion: its memory is at its last reversal."""

    def __init__(self, joint: Joint, shape: RealArray) -> None:
        self.memory = Memory(joint)
        self.shape = shape
        self.sense = 1.0  # of u'
        self.reversals: list[float] = []
        self.path: list[tuple[RealArray, RealArray]] = []

    def start(self, y: RealArray, slope: RealArray) -> None:
        """From virgin rest to where it begins, and the direction from there: by u', or by u'' where
        u' is 0. Where that is 0 too, an event comes as soon as the direction reverses."""
        self.memory.advance(float(self.shape @ y[: len(self.shape)]))
        speeds = [float(self.shape @ of[len(self.shape) :]) for of in (y, slope)]
        self.sense = -1.0 if (speeds[0] or speeds[1]) < 0.0 else 1.0

    def rate(self, y: RealArray) -> float:
        """Rate of u in the present direction; given y', its acceleration."""
        return self.sense * float(self.shape @ y[len(self.shape) :])

    def event(self) -> Any:
        """Falls through 0 at a reversal; above 0 while the joint is at rest."""

        def goes_on(_: float, y: RealArray) -> float:
            return self.rate(y) or 1.0

        goes_on.terminal = True  # type: ignore[attr-defined]
        goes_on.direction = -1.0  # type: ignore[attr-defined]
        return goes_on

    def record(self, displacement: RealArray) -> None:
        """The branch of the last reversal."""
        u = self.shape @ displacement
        self.path.append((u, np.array([self.memory.trial(at).force for at in u.tolist()])))

    def turn(self, time: float, displacement: RealArray) -> None:
        self.memory.advance(float(self.shape @ displacement))
        self.sense = -self.sense
        self.reversals.append(time)

    def finished(self, displacement: RealArray) -> JointPath:
        self.memory.advance(float(self.shape @ displacement))
        u, force = (np.concatenate(parts) for parts in zip(*self.path))
        return JointPath(u, force, np.array(self.reversals), self.memory)


class _System:
    def __init__(self, mass: object, damping: object, stiffness: object,
                 joints: list[tuple[Joint, Any]], force: Optional[Callable[[float], Any]]) -> None:  # fmt: skip
        self.mass = _matrix(mass, "mass", None)
        self.dofs = n = len(self.mass)
        self.damping = _matrix(damping, "damping", n)
        self.stiffness = _matrix(stiffness, "stiffness", n)
        self.joints = [
            _Joint(joint, real_array(shape, f"joints[{j}]: shape", length=n,
                                     per="one per degree of freedom"))
            for j, (joint, shape) in enumerate(joints)
        ]  # fmt: skip
        if force is not None and not callable(force):
            raise InputError(f"force = {shown(force)}; must be a function of time, or None")
        self.force = force
        try:
            self.inverse_mass = np.linalg.inv(self.mass)
        except np.linalg.LinAlgError:
            raise InputError("mass is singular; must have an inverse") from None
        least = float(np.linalg.eigvalsh(0.5 * (self.mass + self.mass.T)).min())
        if least <= 0.0:
            raise InputError(f"mass has an eigenvalue of {least:.3g} kg; must be positive definite")
        self.linear = -self.inverse_mass @ np.hstack((self.stiffness, self.damping))
        self.shapes = np.array([joint.shape for joint in self.joints]).reshape(-1, n)
        self.inverse_shapes = self.inverse_mass @ self.shapes.T
        stuck = self.stiffness + (self.shapes.T * [j.memory.joint.stiffness for j in self.joints]
                                  ) @ self.shapes  # fmt: skip
        square = np.abs(np.linalg.eigvals(self.inverse_mass @ stuck))
        self.frequencies = np.sqrt(square)  # rad/s, of the stuck structure
        self.shortest_period = 2.0 * np.pi / max(self.frequencies.max(), 1e-300)

    def acting(self, t: float) -> RealArray:
        """f(t), checked."""
        if self.force is None:
            return np.zeros(self.dofs)
        return real_array(self.force(t), f"force({t})", length=self.dofs,
                          per="one per degree of freedom")  # fmt: skip

    def slope(self, t: float, y: RealArray) -> RealArray:
        n = self.dofs
        forces = [j.memory.trial(u).force for j, u in zip(self.joints, (self.shapes @ y[:n]).tolist())]
        slope = np.empty(2 * n)
        slope[:n] = y[n:]
        slope[n:] = self.linear @ y - self.inverse_shapes @ forces
        if self.force is not None:
            slope[n:] += self.inverse_mass @ np.asarray(self.force(t), dtype=float)
        return slope

    def resolution(self, start: RealArray, begin: float, end: float) -> float:
        """A thousandth of how far it moves."""
        acting = max(abs(self.inverse_mass @ self.acting(t)).max()
                     for t in np.linspace(begin, end, 200))  # fmt: skip
        slowest = max(self.frequencies.min(), 1e-3 * self.frequencies.max(), 1e-300)
        given = max(abs(start[: self.dofs]).max(), abs(start[self.dofs :]).max() / slowest)
        return 1e-3 * (max(given, acting / slowest**2) or 1.0)


def _solve(system: _System, start: RealArray, begin: float, end: float,
           times: Optional[RealArray], options: dict[str, Any]) -> JointedSolution:  # fmt: skip
    from scipy.integrate import solve_ivp

    n = system.dofs
    events = [joint.event() for joint in system.joints]
    t, y = begin, start
    slope = system.slope(t, y)
    for joint in system.joints:
        joint.start(y, slope)
    taken = 0  # of the times
    evaluations = 0
    pieces: list[tuple[RealArray, RealArray]] = []
    while True:
        piece = solve_ivp(system.slope, (t, end), y, events=events, dense_output=times is not None,
                          **options)  # fmt: skip
        if not piece.success:
            raise Error(f"solve_ivp: {piece.message} It reached {piece.t[-1]} s.")
        evaluations += piece.nfev
        t, y = float(piece.t[-1]), piece.y[:, -1]
        last = piece.status == 0
        if times is None:
            some = slice(0, len(piece.t) if last else int(np.searchsorted(piece.t, t)))
            at, states = piece.t[some], piece.y[:, some]
        else:
            upto = len(times) if last else int(np.searchsorted(times, t))
            at, taken = times[taken:upto], upto
            states = piece.sol(at) if len(at) else np.empty((2 * n, 0))
        pieces.append((at, states))
        for joint in system.joints:
            joint.record(states[:n])
        if last:
            break
        slope = system.slope(t, y)
        for joint, turned in zip(system.joints, piece.t_events):
            # Of joints that reverse at once solve_ivp names one. One that has just reversed may
            # move back by rounding, but is driven on.
            if len(turned) or (joint.rate(y) < 0.0 and joint.rate(slope) < 0.0):
                joint.turn(t, y[:n])
    states = np.hstack([of for _, of in pieces])
    return JointedSolution(
        time=np.concatenate([at for at, _ in pieces]),
        displacement=states[:n],
        velocity=states[n:],
        joints=tuple(joint.finished(y[:n]) for joint in system.joints),
        evaluations=evaluations,
    )
