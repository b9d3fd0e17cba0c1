# SPDX-License-Identifier: MIT
"""Converts datasets 58 of universal files, as dictionaries of pyuff, to recordings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Union

import numpy as np

from . import _core
from ._arguments import real, real_array, real_or_complex_array, sequence, text, whole
from ._errors import InputError
from ._recordings import Recording
from ._results import warn_of

_LARGEST = 2**31 - 1
_WHOLE = ("func_type", "func_id", "ver_num", "load_case_id", "rsp_node", "rsp_dir", "ref_node",
          "ref_dir")  # fmt: skip
_QUANTITIES = ("abscissa", "ordinate", "orddenom", "z_axis")
_WHOLE_OF_QUANTITY = ("spec_data_type", "len_unit_exp", "force_unit_exp", "temp_unit_exp")


def recordings_from_uff(functions: Union[Mapping[str, Any], Sequence[Mapping[str, Any]]], *,
                      source: str = "pyuff") -> list[Recording]:  # fmt: skip
    """Converts datasets 58, as dictionaries of pyuff, to recordings.

    Parameters
    ----------
    functions : mapping or sequence of mapping
        With ``type`` 58, ``data``, and ``x`` or, with ``abscissa_spacing`` 1, ``abscissa_min`` and
        ``abscissa_inc``; other keys of pyuff are used too: labels of units, types of data, nodes,
        ``id1`` to ``id5``. Sets of other types are left out.
    source : str
        Source of the recordings.

    Returns
    -------
    list of Recording
        Consecutive functions over one axis form one recording, as `read_recordings` does for a
        universal file; a step that is one over a whole number of hertz to five digits is rounded to
        it.

    Raises
    ------
    ValueError
        Where a key is missing or of the wrong kind; the message names it.
    """
    given = [functions] if isinstance(functions, Mapping) else sequence(functions, "functions",
                                                                        "mappings")  # fmt: skip
    taken = []
    for i, function in enumerate(given):
        if not isinstance(function, Mapping):
            raise InputError(f"functions[{i}] = {type(function).__name__}; must be a mapping")
        if function.get("type", 58) == 58:
            taken.append(_checked(function, f"functions[{i}]"))
    if not taken:
        raise InputError("functions has no set of type 58; must have at least one")
    found, warnings = _core.recordings_of_functions(taken, text(source, "source"))
    warn_of(warnings)
    return [Recording._of(recording) for recording in found]


def _label(value: object, name: str) -> str:
    """The text of a key; NONE and blanks count as empty."""
    if value is None:
        return ""
    if not isinstance(value, str):
        raise InputError(f"{name} = {value!r}; must be a text")
    label = value.strip()
    return "" if label.upper() == "NONE" else label


def _checked(function: Mapping[str, Any], at: str) -> dict[str, Any]:
    if function.get("data") is None:
        raise InputError(f"{at}: data is missing; must be an array")
    taken: dict[str, Any] = {"data": real_or_complex_array(function["data"], f"{at}: data")}

    def number(key: str) -> int:
        value = function.get(key)
        return whole(0 if value is None else value, f"{at}: {key}", -_LARGEST, _LARGEST)

    for key in (f"id{i}" for i in range(1, 6)):
        taken[key] = _label(function.get(key), f"{at}: {key}")
    for key in _WHOLE:
        taken[key] = number(key)
    for point in ("rsp", "ref"):
        key = f"{point}_ent_name"
        taken[key] = _label(function.get(key), f"{at}: {key}")
    for quantity in _QUANTITIES:
        for part in _WHOLE_OF_QUANTITY:
            taken[f"{quantity}_{part}"] = number(f"{quantity}_{part}")
        for key in (f"{quantity}_axis_lab", f"{quantity}_axis_units_lab"):
            taken[key] = _label(function.get(key), f"{at}: {key}")
    taken["z_axis_value"] = real(function.get("z_axis_value", 0.0), f"{at}: z_axis_value")
    return taken | _abscissa(function, at, len(np.asarray(taken["data"])))


def _abscissa(function: Mapping[str, Any], at: str, points: int) -> dict[str, Any]:
    spacing = function.get("abscissa_spacing")
    even = "abscissa_inc" in function if spacing is None else bool(whole(
        spacing, f"{at}: abscissa_spacing", 0, 1))  # fmt: skip
    if even:
        if "abscissa_inc" not in function:
            raise InputError(f"{at}: abscissa_inc is missing; must be the step of the abscissa")
        return {"abscissa_spacing": 1, "x": None,
                "abscissa_min": real(function.get("abscissa_min", 0.0), f"{at}: abscissa_min"),
                "abscissa_inc": real(function["abscissa_inc"], f"{at}: abscissa_inc")}  # fmt: skip
    if function.get("x") is None:
        raise InputError(f"{at}: x is missing; must be an array, one per point")
    x = real_array(function["x"], f"{at}: x", length=points, per="one per value")
    return {"abscissa_spacing": 0, "x": x, "abscissa_min": 0.0, "abscissa_inc": 0.0}
