# SPDX-License-Identifier: MIT
"""The errors of microslip, and the category of its warnings."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """Base class of all errors of microslip."""


class InputError(Error, ValueError):
    """A given value breaks a rule: "what = value; rule. remedy"."""


class FormatError(Error, ValueError):
    """A file does not have the required format: "place: expected …, found …. remedy"."""


class FileError(Error, OSError):
    """A file cannot be opened, read or written."""


class Cancelled(Error):
    """The progress callback returned False. No files are left behind."""


class NotConverged(Error):
    """A method ended before its stopping criterion was met.

    Attributes
    ----------
    result
        The result up to there, the same object as with ``strict=False``.
    """

    def __init__(self, text: str, result: Any) -> None:
        super().__init__(text, result)
        self.result = result

    def __str__(self) -> str:
        return str(self.args[0])


class MicroslipWarning(UserWarning):
    """A warning that concerns data or a result: "code: text"."""
