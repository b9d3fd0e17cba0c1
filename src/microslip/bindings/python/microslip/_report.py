# SPDX-License-Identifier: MIT
"""The report of a test: one page, offline, interactive."""

from __future__ import annotations

from typing import Optional

from . import _core
from ._arguments import Path, Progress, flag, text, whole
from ._arguments import path as path_of
from ._arguments import progress as progress_of
from ._results import warn_of


def report(
    folder: Path,
    out: Path,
    *,
    title: Optional[str] = None,
    records: int = 8,
    pictures: bool = True,
    progress: Optional[Progress] = None,
) -> int:
    """Writes the report of the test in a folder: one HTML file, at once and whole.

    Parameters
    ----------
    folder : path
        With any of rig.toml, levels.csv, joint.json, density.csv, recordings, verification.csv, or
        what `calibrate` writes.
    out : path
        The file to write.
    title : str, optional
        Its title; the name of the folder without it.
    records : int
        Number of recordings shown over time; 1 to 1000.
    pictures : bool
        Whether to include the figures for print that gnuplot draws, where it is installed.
    progress : callable, optional
        Called with (recordings done, recordings); False cancels.

    Returns
    -------
    int
        Bytes of the file.

    Raises
    ------
    FileError, FormatError
        Where a file cannot be read, or `out` cannot be written.
    ValueError
        Where the folder holds nothing of a test.
    """
    size, warnings = _core.report(
        path_of(folder, "folder"),
        path_of(out, "out"),
        None if title is None else text(title, "title"),
        whole(records, "records", 1, 1000),
        flag(pictures, "pictures"),
        "microslip.report",
        progress_of(progress),
    )
    warn_of(warnings)
    bytes_written: int = size
    return bytes_written
