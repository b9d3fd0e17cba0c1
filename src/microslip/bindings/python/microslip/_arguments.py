# SPDX-License-Identifier: MIT
"""Converts the arguments of users to those of the compiled half, checked here so that each message
names the argument as the user knows it."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._errors import InputError

#: Anything that ``numpy.asarray`` converts to real numbers.
ArrayLike = npt.ArrayLike
#: A float64 array.
RealArray = npt.NDArray[np.float64]
#: A complex128 array.
ComplexArray = npt.NDArray[np.complex128]
#: Called with (done, total) some ten times a second; False cancels.
Progress = Callable[[int, int], Optional[bool]]
#: The path of a file.
Path = Union[str, "os.PathLike[str]"]


def shown(value: object) -> str:
    """The value as messages show it, in one short line."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 60 else text[:57] + "..."


def real(value: object, name: str) -> float:
    """A finite number."""
    if type(value) is not float:
        value = _number(value, name)
    if not math.isfinite(value):
        raise InputError(f"{name} = {value}; must be finite")
    return value


def _number(value: object, name: str) -> float:
    if isinstance(value, (complex, np.complexfloating)):
        raise InputError(f"{name} = {shown(value)}; must be real, not complex")
    if isinstance(value, np.ndarray) and value.shape == () and value.dtype.kind in "biuf":
        return float(value)
    if isinstance(value, (str, bytes, bool, np.bool_, np.ndarray)) or value is None:
        raise InputError(f"{name} = {shown(value)}; must be a number")
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{name} = {shown(value)}; must be a number") from None


def positive(value: object, name: str) -> float:
    """A finite number above 0."""
    number = real(value, name)
    if number <= 0.0:
        raise InputError(f"{name} = {number}; must be positive")
    return number


def not_negative(value: object, name: str) -> float:
    """A finite number, 0 or more."""
    number = real(value, name)
    if number < 0.0:
        raise InputError(f"{name} = {number}; must not be negative")
    return number


def whole(value: object, name: str, least: int = 0, most: int = 2**31 - 1) -> int:
    """An integer in a range."""
    if isinstance(value, (bool, np.bool_)):
        raise InputError(f"{name} = {value}; must be a whole number")
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise InputError(f"{name} = {shown(value)}; must be a whole number") from None
    if not least <= number <= most:
        raise InputError(f"{name} = {number}; must be from {least} to {most}")
    return number


def flag(value: object, name: str) -> bool:
    """True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise InputError(f"{name} = {shown(value)}; must be True or False")
    return bool(value)


def text(value: object, name: str) -> str:
    """A string, not empty."""
    if not isinstance(value, str) or not value:
        raise InputError(f"{name} = {shown(value)}; must be a text")
    return value


def one_of(value: object, name: str, choices: Sequence[str]) -> str:
    """One of the choices."""
    if not isinstance(value, str) or value not in choices:
        raise InputError(f"{name} = {shown(value)}; must be one of {', '.join(choices)}")
    return value


def path(value: object, name: str) -> str:
    """The path of a file."""
    try:
        found = os.fsdecode(value)  # type: ignore[arg-type]
        found.encode()
    except UnicodeError:
        raise InputError(f"{name} = {shown(value)}; must be in UTF-8") from None
    except (TypeError, ValueError):
        raise InputError(f"{name} = {shown(value)}; must be the path of a file") from None
    if "\0" in found:
        raise InputError(f"{name} = {shown(value)}; must not contain a null character")
    if found == "-":
        raise InputError(f"{name} = '-'; must be the path of a file: standard input and output"
                         " are not available here. A file of that name is './-'")  # fmt: skip
    return found


def progress(value: object) -> Optional[Progress]:
    """A callback or None."""
    if value is not None and not callable(value):
        raise InputError(f"progress = {shown(value)}; must be callable, or None")
    return value


def mapping(value: object, name: str) -> Mapping[str, Any]:
    """A mapping with texts as keys."""
    if not isinstance(value, Mapping):
        raise InputError(f"{name} = {shown(value)}; must be a mapping of names")
    for key in value:
        text(key, f"a name in {name}")
    return value


def sequence(value: object, name: str, of: str) -> Sequence[Any]:
    """A list or tuple."""
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Sequence):
        raise InputError(f"{name} = {shown(value)}; must be a list of {of}")
    return value


def names(value: Any, name: str) -> list[str]:
    """Strings, from any iterable of them except a string itself."""
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Iterable):
        raise InputError(f"{name} = {shown(value)}; must be a list of names")
    return [text(one, name) for one in value]


def _array(value: object, name: str, kinds: str, rule: str) -> npt.NDArray[Any]:
    if value is None:
        raise InputError(f"{name} is None; must be {rule}")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError, OverflowError):
        raise InputError(f"{name} has rows of different lengths; must be {rule}") from None
    if isinstance(value, np.ma.MaskedArray) and bool(np.any(value.mask)):
        raise InputError(f"{name} has masked values; must be {rule}. Leave them out or fill them.")
    if array.size > 0 and array.dtype.kind not in kinds:
        found = {"c": "complex numbers", "O": "Python objects", "U": "texts", "S": "texts",
                 "b": "truth values", "M": "dates", "m": "times"}  # fmt: skip
        raise InputError(
            f"{name} has {found.get(array.dtype.kind, str(array.dtype))}; must be {rule}"
        )
    return array


def _dimensions(array: npt.NDArray[Any], name: str, ndim: Optional[int], empty: bool) -> None:
    if ndim is not None and array.ndim != ndim:
        shape = "x".join(map(str, array.shape)) or "a single number"
        raise InputError(f"{name} has the shape {shape}; must have {ndim} dimension"
                         f"{'s' if ndim > 1 else ''}")  # fmt: skip
    if array.size == 0 and not empty:
        raise InputError(f"{name} is empty; must have at least one number")


def check_finite(array: npt.NDArray[Any], name: str) -> None:
    """Names the first number that is not finite."""
    finite = np.isfinite(array)
    if not finite.all():
        if array.ndim == 0:
            raise InputError(f"{name} = {array}; must be finite")
        at = tuple(int(i) for i in np.argwhere(~finite)[0])
        raise InputError(f"{name}[{', '.join(map(str, at))}] = {array[at]}; must be finite")


def real_array(
    value: object,
    name: str,
    *,
    ndim: Optional[int] = 1,
    length: Optional[int] = None,
    per: str = "",
    empty: bool = False,
) -> RealArray:
    """Finite numbers as an aligned C-contiguous float64 array; copied only where needed."""
    rule = "an array of numbers"
    array = _array(value, name, "iuf", rule)
    _dimensions(array, name, ndim, empty)
    if length is not None and array.shape[-1] != length:
        raise InputError(f"{name} has {array.shape[-1]} numbers; must have {length}, {per}")
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        with np.errstate(over="ignore"):
            array = array.astype(np.float64)
    array = np.require(array, np.float64, ("C", "A"))
    check_finite(array, name)
    return array


def optional_array(value: object, name: str, length: int, per: str) -> Optional[RealArray]:
    """As `real_array`, of an argument that may be None."""
    return None if value is None else real_array(value, name, length=length, per=per)


def broadcast(value: object, name: str, length: int, per: str) -> RealArray:
    """One number for all, or one for each."""
    array = real_array(value, name, ndim=None)
    if array.ndim == 0:
        return np.full(length, real(value, name))
    return real_array(array, name, length=length, per=per)


def complex_array(value: object, name: str) -> ComplexArray:
    """Finite numbers as a C-contiguous complex128 array of one dimension."""
    array = _array(value, name, "iufc", "an array of numbers")
    _dimensions(array, name, 1, False)
    array = np.require(array, np.complex128, ("C", "A"))
    check_finite(array, name)
    return array


def real_or_complex_array(value: object, name: str) -> Union[RealArray, ComplexArray]:
    """Finite numbers as a C-contiguous float64 or complex128 array of one dimension."""
    array = _array(value, name, "iufc", "an array of numbers")
    return complex_array(array, name) if array.dtype.kind == "c" else real_array(array, name)


def attributes(value: object, name: str) -> tuple[tuple[str, str], ...]:
    """Pairs of strings, from a mapping or a list."""
    pairs = value.items() if isinstance(value, Mapping) else value
    try:
        found = tuple((key, content) for key, content in pairs)  # type: ignore[attr-defined]
    except (TypeError, ValueError):
        raise InputError(f"{name} = {shown(value)}; must be a mapping or pairs of texts") from None
    for key, content in found:
        if not isinstance(key, str) or not isinstance(content, str):
            raise InputError(f"{name}[{shown(key)}] = {shown(content)}; must be a text")
    return found
