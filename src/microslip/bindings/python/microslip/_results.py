# SPDX-License-Identifier: MIT
"""Parts that all results have: the summary of the method and the warnings."""

from __future__ import annotations

import html
import re
import sys
import warnings as python_warnings
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, Protocol, TypeVar

import numpy as np

from ._errors import MicroslipWarning, NotConverged


@dataclass(frozen=True)
class Summary:
    """Why a numerical method stopped.

    Attributes
    ----------
    method : str
        Its name.
    reason : str
        Why it stopped, in words.
    converged : bool
        Whether its stopping criterion was met and no check of the result failed.
    usable : bool
        Whether there is a result to use, with the reason in mind.
    residual : float
        Measure of the stopping criterion, relative, 1.
    iterations : int
        Number of iterations.
    seconds : float
        Wall time, s.
    text : str
        One line per fact.
    """

    method: str
    reason: str
    converged: bool
    usable: bool
    residual: float
    iterations: int
    seconds: float
    text: str


@dataclass(frozen=True)
class Note:
    """A warning of a result.

    Attributes
    ----------
    code : str
        Stable, for scripts: ``density_negative``.
    text : str
        One sentence with the figures and the remedy.
    """

    code: str
    text: str

    def __str__(self) -> str:
        return f"{self.code}: {self.text}"


class HasSummary(Protocol):
    """A result with warnings and a summary."""

    @property
    def summary(self) -> Summary: ...

    @property
    def warnings(self) -> tuple[Note, ...]: ...


Result = TypeVar("Result", bound=HasSummary)


def notes(pairs: Iterable[tuple[str, str]]) -> tuple[Note, ...]:
    return tuple(Note(code, text) for code, text in pairs)


def summary_of(numbers: Mapping[str, Any]) -> Summary:
    return Summary(**numbers)


class _WarningText(str):
    """The text of a warning, equal to another that differs in figures alone.

    `warnings` shows a text once per line of a program: in a loop, the same warning with other
    figures is no other. Digits within names and quotes, and numbers of places, distinguish, as of
    `joint1` and `joint2`, `mode 1` and `mode 2`.
    """

    _FIGURES = re.compile(
        r"'[^']*'|\b(?:mode|level|row|record|recording|assembly|node|test|sensor) \d+"
        r"|(?<![\w.])[-+]?\d[\d.]*(?:e[-+]?\d+)?", re.IGNORECASE)  # fmt: skip

    def _without_figures(self) -> str:
        def kept(found: re.Match[str]) -> str:
            return "#" if found[0][0] in "+-0123456789" else found[0]

        return self._FIGURES.sub(kept, str(self))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, _WarningText):
            return self._without_figures() == other._without_figures()
        return super().__eq__(other)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash(self._without_figures())


def warn(text: str) -> None:
    """Issues a warning at the user's line that led here."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").startswith("microslip."):
        level, frame = level + 1, frame.f_back
    python_warnings.warn(_WarningText(text), MicroslipWarning, stacklevel=level)


def warn_of(pairs: Iterable[tuple[str, str]]) -> None:
    """Issues warnings of the compiled half."""
    for note in notes(pairs):
        warn(str(note))


def fix(value: object) -> None:
    """Makes the arrays of a result read-only: they are its own, and it is shared freely."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif is_dataclass(value):
        for field in fields(value):
            fix(getattr(value, field.name))
    elif isinstance(value, (tuple, list)):
        for one in value:
            fix(one)
    elif isinstance(value, Mapping):
        fix(list(value.values()))


def reported(result: Result, strict: bool) -> Result:
    """Issues the warnings of a result, and raises where it did not converge and `strict` is set.
    Its arrays are read-only from here on."""
    fix(result)
    for note in result.warnings:
        warn(str(note))
    if not result.summary.converged:
        text = f"{result.summary.method}: {result.summary.reason}"
        if strict:
            raise NotConverged(f"{text}. With strict=False the partial result is returned.", result)
        warn(f"not_converged: {text}")
    return result


def si(value: float, unit: str, digits: int = 5) -> str:
    """ "1.7e+05 N/m"."""
    return f"{value:.{digits}g}" if unit == "1" else f"{value:.{digits}g} {unit}"


def text_table(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """A title, then one line per fact, for `repr`."""
    pairs = list(rows)
    width = max((len(name) for name, _ in pairs), default=0)
    return "\n".join([title, *(f"  {name:<{width}}  {value}" for name, value in pairs)])


def html_table(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """The title and the facts as HTML, for notebooks."""
    cells = "".join(
        f'<tr><th style="text-align:left">{html.escape(name)}</th>'
        f'<td style="text-align:left">{html.escape(value)}</td></tr>'
        for name, value in rows
    )
    return f"<table><caption>{html.escape(title)}</caption>{cells}</table>"


class Shown:
    """Shows itself by a title and facts, as text and in notebooks."""

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        raise NotImplementedError

    def __repr__(self) -> str:
        return text_table(*self._facts())

    def _repr_html_(self) -> str:
        return html_table(*self._facts())


def outcome(result: HasSummary) -> list[tuple[str, str]]:
    """The last facts of every result."""
    rows = [("status", "converged" if result.summary.converged else
             f"NOT CONVERGED: {result.summary.reason}")]  # fmt: skip
    rows.extend(("warning", str(note)) for note in result.warnings)
    return rows
