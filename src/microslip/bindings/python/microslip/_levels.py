# SPDX-License-Identifier: MIT
"""Levels: measured quantities of a joint at rising amplitude."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _core
from ._arguments import ArrayLike, Path, RealArray, flag, one_of, optional_array, real_array
from ._arguments import path as path_of
from ._errors import InputError
from ._plot import plot_levels
from ._results import Note, Shown, fix, notes, si, warn_of

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

_UNITS = {
    "amplitude": "m",
    "dissipation": "J",
    "amplitude_std": "m",
    "dissipation_std": "J",
    "secant_stiffness": "N/m",
    "secant_stiffness_std": "N/m",
    "linear_dissipation": "J",
    "frequency": "Hz",
    "frequency_std": "Hz",
}
#: Columns of a table that qualify levels, in addition to the measured quantities.
_QUALIFIERS = ("reversals", "flags", "assembly")
_FREQUENCIES = ("frequency", "frequency_std")
_HEADER = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\))?\s*")
_EACH = "one per amplitude"


@dataclass(frozen=True, init=False, repr=False, eq=False)
class Levels(Shown):
    """One entry per level of vibration. Immutable: arrays are copied, and read-only.

    Parameters
    ----------
    amplitude : array_like
        A of the joint displacement, m, shape (n,); above 0.
    dissipation : array_like
        D, energy lost per cycle, J, shape (n,); 0 or more.
    amplitude_std, dissipation_std : array_like, optional
        Standard deviations, m and J, shape (n,).
    secant_stiffness, secant_stiffness_std : array_like, optional
        k_eq of the first harmonic and its standard deviation, N/m, shape (n,).
    linear_dissipation : array_like, optional
        Linear loss that was subtracted from the input energy to get D, J, shape (n,).
    frequency, frequency_std : array_like, optional
        Resonance frequency at the level and its standard deviation, Hz, shape (n,).

    Raises
    ------
    ValueError
        Where a column is not an array of n finite numbers; the message names it.
    """

    amplitude: RealArray
    dissipation: RealArray
    amplitude_std: Optional[RealArray]
    dissipation_std: Optional[RealArray]
    secant_stiffness: Optional[RealArray]
    secant_stiffness_std: Optional[RealArray]
    linear_dissipation: Optional[RealArray]
    frequency: Optional[RealArray]
    frequency_std: Optional[RealArray]
    _notes: tuple[Note, ...]

    def __init__(
        self,
        amplitude: ArrayLike,
        dissipation: ArrayLike,
        amplitude_std: Optional[ArrayLike] = None,
        dissipation_std: Optional[ArrayLike] = None,
        secant_stiffness: Optional[ArrayLike] = None,
        secant_stiffness_std: Optional[ArrayLike] = None,
        linear_dissipation: Optional[ArrayLike] = None,
        frequency: Optional[ArrayLike] = None,
        frequency_std: Optional[ArrayLike] = None,
    ) -> None:
        first = real_array(amplitude, "amplitude")
        given = {
            "dissipation": real_array(dissipation, "dissipation", length=len(first), per=_EACH),
            "amplitude_std": amplitude_std,
            "dissipation_std": dissipation_std,
            "secant_stiffness": secant_stiffness,
            "secant_stiffness_std": secant_stiffness_std,
            "linear_dissipation": linear_dissipation,
            "frequency": frequency,
            "frequency_std": frequency_std,
        }
        object.__setattr__(self, "_notes", ())
        for name, values in (("amplitude", first), *given.items()):
            checked = optional_array(values, name, len(first), _EACH)
            object.__setattr__(self, name, None if checked is None else checked.copy())
        fix(self)

    @classmethod
    def read(cls, path: Path, *, use_inner_reversals: bool = False,
             assemblies: Optional[str] = None) -> Levels:  # fmt: skip
        """Reads the levels of a levels.csv, see docs/file_formats.md.

        Parameters
        ----------
        path : path-like
            Path of the file.
        use_inner_reversals : bool
            Whether to take levels with more than two reversals per cycle (column ``reversals``),
            whose D is not that of one loop. Otherwise they are left out with a warning.
        assemblies : {"none"}, optional
            States that all levels are of one joint although a column ``assembly`` names several.

        Raises
        ------
        FileError, FormatError, ValueError
            Where the file cannot be read, or a cell breaks its rule.
        """
        if assemblies is not None:
            one_of(assemblies, "assemblies", ("none",))
        columns, warnings = _core.read_levels(
            path_of(path, "path"), flag(use_inner_reversals, "use_inner_reversals"),
            assemblies is not None,
        )  # fmt: skip
        warn_of(warnings)
        levels = cls(**columns)
        object.__setattr__(levels, "_notes", notes(warnings))
        return levels

    def write(self, path: Path) -> None:
        """Writes a levels.csv: at once and whole, or not at all."""
        _core.write_file(path_of(path, "path"), _core.levels_csv(self._columns()).encode())

    @classmethod
    def of(cls, table: Any, *, use_inner_reversals: bool = False,
           assemblies: Optional[str] = None) -> Levels:  # fmt: skip
        """Levels from a pandas frame or a mapping, by the rules of `read`.

        Parameters
        ----------
        table : DataFrame or mapping
            With columns ``amplitude`` and ``dissipation``, and others as of the class. A unit may
            follow a name as in levels.csv, ``amplitude [um]``; it is converted to that of SI.
            ``reversals``, ``flags`` and ``assembly`` have the same meaning as there. Other columns
            are ignored, unless their names look like mistakes: ``dissipation_sd``.
        use_inner_reversals, assemblies
            As of `read`.

        Raises
        ------
        ValueError
            Where a column is missing or breaks a rule; the message names it.
        """
        flag(use_inner_reversals, "use_inner_reversals")
        if assemblies is not None:
            one_of(assemblies, "assemblies", ("none",))
        if isinstance(table, Levels):
            return table
        if not isinstance(table, Mapping) and not hasattr(table, "columns"):
            raise InputError(f"table = {type(table).__name__}; must be a DataFrame or a mapping")
        columns = _columns_of(table)
        for needed in ("amplitude", "dissipation"):
            if needed not in columns:
                raise InputError(f"{needed} is missing; must be a column of the table")
        qualifiers = {name: columns.pop(name, None) for name in _QUALIFIERS}
        if assemblies is None and qualifiers["assembly"] is not None:
            _check_one_assembly(qualifiers["assembly"])
        return _usable(cls(**columns), qualifiers, use_inner_reversals)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of levels.csv."""
        import pandas

        return pandas.DataFrame(
            {f"{name} [{_UNITS[name]}]": values for name, values in self._columns().items()
             if values is not None}  # fmt: skip
        )

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws D over A on logarithmic axes, by matplotlib."""
        return plot_levels(ax, style, self.amplitude, self.dissipation, self.amplitude_std,
                           self.dissipation_std)  # fmt: skip

    def __len__(self) -> int:
        return len(self.amplitude)

    def __setstate__(self, state: dict[str, Any]) -> None:
        vars(self).update(state)
        fix(self)

    def _at(self, chosen: Any) -> Levels:
        return Levels(**{name: None if values is None else values[chosen]
                         for name, values in self._columns().items()})  # type: ignore[arg-type] # fmt: skip

    def _columns(self) -> dict[str, Optional[RealArray]]:
        return {name: getattr(self, name) for name in _UNITS}

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("levels", str(len(self)))]
        for name, values in self._columns().items():
            if values is not None:
                rows.append((name, f"{si(values.min(), '1')} to {si(values.max(), _UNITS[name])}"))
        return "Levels", rows


def _columns_of(table: Any) -> dict[str, Any]:
    """The columns of a table that are used, by names without units."""
    named = [(key, *_name_and_unit(str(key))) for key in table.keys()]
    resonance = any(name == "resonance_frequency" for _, name, _ in named)
    columns: dict[str, Any] = {}
    keys: dict[str, Any] = {}
    for key, name, unit in named:
        if resonance and name in _FREQUENCIES:
            continue  # of the drive
        if name.removeprefix("resonance_") in _FREQUENCIES:
            name = name.removeprefix("resonance_")
        if name not in _UNITS and name not in _QUALIFIERS:
            _check_no_mistake(str(key), name)
            continue
        if name in keys:
            raise InputError(f"{keys[name]} and {key} are both columns; must be one of them")
        keys[name] = key
        columns[name] = _in_si(table[key], str(key), unit, name)
    return columns


def _in_si(values: Any, key: str, unit: str, name: str) -> Any:
    """Values of a column in the unit of its quantity."""
    if name not in _UNITS or not unit or unit == _UNITS[name]:
        return values
    try:
        numerator, denominator, si_unit = _core.unit(unit)
    except InputError as error:
        raise InputError(f"column {key}: {error}") from None
    if si_unit != _UNITS[name]:
        raise InputError(f"{key} is in a unit of another quantity; must be in one of {_UNITS[name]}")
    return real_array(values, key) * numerator / denominator


def _name_and_unit(key: str) -> tuple[str, str]:
    """Splits ``amplitude [m]`` or ``amplitude (m)`` into name and unit."""
    found = _HEADER.fullmatch(key)
    return (found[1], found[2] or found[3] or "") if found else (key, "")


def _check_no_mistake(key: str, name: str) -> None:
    """Refuses an ignored column whose name looks mistyped."""
    known = [*_UNITS, *_QUALIFIERS]
    plain = name.strip().lower().replace(" ", "_")
    near = get_close_matches(plain, known, 1, 0.8)
    near = near or [stem for stem in known if re.match(rf"{stem}(?![a-z])", plain)]
    if near:
        raise InputError(f"{key} is no column of levels; did you mean {near[0]}? Else rename it."
                         " Columns are"
                         f" {', '.join(known)}")  # fmt: skip


def _check_one_assembly(assembly: Any) -> None:
    found = dict.fromkeys(str(name) for name in assembly)
    if len(found) > 1:
        raise InputError(f"assembly has {len(found)} names, {', '.join(found)}; must be one. Keep the"
                         " rows of one, or give assemblies='none' where all levels are of one"
                         " joint")  # fmt: skip


def _usable(levels: Levels, qualifiers: dict[str, Any], use_inner_reversals: bool) -> Levels:
    """Drops levels whose D is not that of one loop [AR14 (7)]; warns of them and of flags."""
    count = len(levels)
    turns = optional_array(qualifiers["reversals"], "reversals", count, _EACH)
    inner = np.zeros(count, dtype=bool) if turns is None else turns > 2.0
    flags = [] if qualifiers["flags"] is None else list(qualifiers["flags"])
    if inner.any() and not use_inner_reversals:
        if inner.all():
            raise InputError("reversals is above 2 at all levels; must be 2 at one at least."
                             " use_inner_reversals=True takes them nevertheless")  # fmt: skip
        levels = levels._at(~inner)
        flags = [cell for cell, left_out in zip(flags, inner) if not left_out]
    warnings = _warnings_of_flags(flags, len(levels))
    if inner.any():
        code = "inner_reversals_used" if use_inner_reversals else "levels_left_out"
        done = "used nevertheless" if use_inner_reversals else "left out"
        warnings.append(
            (code, f"{inner.sum()} of {count} levels have inner reversals; they were {done}.")
        )
    warn_of(warnings)
    object.__setattr__(levels, "_notes", notes(warnings))
    return levels


def _warnings_of_flags(flags: list[Any], count: int) -> list[tuple[str, str]]:
    """The text of a cell; pandas reads an empty cell as NaN."""
    having = Counter(word for cell in flags if isinstance(cell, str) for word in set(cell.split()))
    if not having:
        return []
    text = ", ".join(f"{word} ({having[word]} of {count})" for word in sorted(having))
    return [("levels_flagged", f"levels carry flags: {text}; docs/file_formats.md explains them under"
             " levels.csv.")]  # fmt: skip
