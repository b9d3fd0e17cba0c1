# SPDX-License-Identifier: MIT
"""The errors of microslip, and the category of its warnings."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """Base of all errors that microslip raises on purpose."""


class InputError(Error, ValueError):
    """A value that was given breaks a rule: "what = value; rule. remedy"."""


class FormatError(Error, ValueError):
    """A file does not have the form it must have: "place: expected …, found …. remedy"."""


class FileError(Error, OSError):
    """A file cannot be opened, read or written."""


class Cancelled(Error):
    """The progress callback returned False. Nothing is left behind."""


class NotConverged(Error):
    """A method ended without meeting its stopping rule.

    Attributes
    ----------
    result
        What was found until then, the same object as with ``strict=False``.
    """

    def __init__(self, text: str, result: Any) -> None:
        super().__init__(text, result)
        self.result = result

    def __str__(self) -> str:
        return str(self.args[0])


class MicroslipWarning(UserWarning):
    """Something in the data or in a result that its user must know of: "code: text"."""
