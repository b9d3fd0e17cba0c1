# SPDX-License-Identifier: MIT
"""Uncertain parameters of a structure, and predictions by draws of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from ._arguments import ArrayLike, RealArray, broadcast, not_negative, one_of, real, whole
from ._draws import JointDraws
from ._errors import InputError
from ._structure import Structure

#: Draws of each joint: one object for the only joint, one or None per joint, or by name.
DrawsOfJoints = Union[JointDraws, Sequence[Optional[JointDraws]], Mapping[str, JointDraws]]
#: Those, or the number of draws to predict: see `draws_and_count`.
DrawsOrCount = Union[DrawsOfJoints, int]


@dataclass(frozen=True, eq=False)
class Spread:
    """Uncertainties of the parameters of a structure: relative standard deviations, of logarithms.

    Parameters
    ----------
    frequency_std, loss_factor_std : float or array_like, optional
        Of frequency and loss factor, independent between modes, 1; one for all or one per mode.
    normal_load_std : float or array_like, optional
        Of the normal load, which scales the slip forces of a joint, 1; one for all or per joint.
    force_gain_std : float or array_like, optional
        Of the gain of the measured force, 1; one for all or one per excitation.
    response_gain_std : float
        Of the gain of the measured response, 1.
    """

    frequency_std: Optional[ArrayLike] = None
    loss_factor_std: Optional[ArrayLike] = None
    normal_load_std: Optional[ArrayLike] = None
    force_gain_std: Optional[ArrayLike] = None
    response_gain_std: float = 0.0

    def _dict(self, structure: Structure) -> dict[str, Any]:
        modes = len(structure.angular_frequency)
        counts = {
            "frequency_std": (modes, "one per mode"),
            "loss_factor_std": (modes, "one per mode"),
            "normal_load_std": (len(structure.joints), "one per joint"),
            "force_gain_std": (len(structure._core.excitations()), "one per excitation"),
        }
        columns: dict[str, Any] = {
            name: None if (value := getattr(self, name)) is None else
            broadcast(value, name, count, per) for name, (count, per) in counts.items()
        }  # fmt: skip
        gain = not_negative(self.response_gain_std, "response_gain_std")
        return {**columns, "response_gain_std": gain}


class PeakBand(NamedTuple):
    """A peak of a curve, with its band over the draws."""

    frequency: float  #: Hz
    frequency_lower: float  #: band of the draws, Hz
    frequency_upper: float
    height: float  #: response, or force at constant response
    height_lower: float  #: band of the draws
    height_upper: float
    draws: int  #: number of draws that have the peak


def is_number(draws: Any) -> bool:
    """Whether draws are given by their number alone."""
    return isinstance(draws, (int, np.integer)) and not isinstance(draws, bool)


def draws_and_count(draws: Any, samples: Any) -> tuple[Any, int]:
    """Draws of joints, and the number to predict. As with the options of the program, `draws` may be
    the number, and `samples` the draws of the joints."""
    if is_number(draws):
        count = whole(draws, "draws", 1, 1_000_000)
        if isinstance(samples, (int, np.integer)):
            if samples not in (0, count):
                raise InputError(f"draws = {draws} and samples = {samples}; must not both be numbers"
                                 " of draws")  # fmt: skip
            samples = None
        return samples, count
    if draws is None and isinstance(samples, (JointDraws, list, tuple, Mapping)):
        raise InputError("draws is missing; must be the number of draws, as samples are the draws of"
                         " the joints")  # fmt: skip
    return draws, whole(samples, "samples", 0, 1_000_000)


def drawn(structure: Structure, draws: Optional[DrawsOrCount], samples: object, seed: object,
          confidence: object, correlation: object,
          spread: Optional[Spread]) -> Optional[dict[str, Any]]:  # fmt: skip
    """The draws as the compiled half takes them; None without draws."""
    draws, count = draws_and_count(draws, samples)
    if spread is not None and not isinstance(spread, Spread):
        raise InputError(f"spread = {spread!r}; must be a microslip.Spread")
    if count == 0:
        for name, value in (("draws", draws), ("spread", spread)):
            if value is not None:
                raise InputError(f"samples is 0; must be the number of draws, as {name} is"
                                 " given")  # fmt: skip
        return None
    return {
        "samples": count,
        "seed": whole(seed, "seed", 0, 2**64 - 1),
        "confidence": real(confidence, "confidence"),
        "correlation": one_of(correlation, "correlation", ("auto", "together", "independent")),
        "joints": _of_joints(structure, draws),
        "has_spread": spread is not None,
        **(spread or Spread())._dict(structure),
    }


def _of_joints(structure: Structure, draws: Any) -> Optional[list[Any]]:
    """Draws per joint; None for those that the model.toml names."""
    names = [joint.name or "" for joint in structure.joints]
    if draws is None:
        return None
    if isinstance(draws, Mapping):
        for name in draws:
            if name not in names:
                raise InputError(f"draws has {name!r}; must be names of joints: {', '.join(names)}")
        draws = [draws.get(name) for name in names]
    given = [draws] if isinstance(draws, JointDraws) else draws
    if isinstance(given, (str, bytes)) or not isinstance(given, Sequence):
        raise InputError(f"draws = {draws!r}; must be microslip.JointDraws, or a list of them")
    if len(given) != len(names):
        raise InputError(f"draws has {len(given)}; must have {len(names)}, one per joint")
    for i, one in enumerate(given):
        if one is not None and not isinstance(one, JointDraws):
            raise InputError(f"draws[{i}] = {one!r}; must be microslip.JointDraws or None")
    return [None if one is None else one._core for one in given]


#: Lower and upper end of a band, one value per point each.
Band = tuple[RealArray, RealArray]
