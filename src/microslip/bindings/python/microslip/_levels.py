# SPDX-License-Identifier: MIT
"""Levels: what was measured of a joint at rising amplitude."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

from . import _core
from ._arguments import ArrayLike, Path, RealArray, flag, one_of, optional_array, real_array
from ._arguments import path as path_of
from ._errors import InputError
from ._results import Note, Shown, notes, si, warn_of

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
_EACH = "one an amplitude"


@dataclass(frozen=True, init=False, repr=False, eq=False)
class Levels(Shown):
    """One entry a level of vibration.

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
        Linear loss that was taken from the input energy to get D, J, shape (n,).
    frequency, frequency_std : array_like, optional
        Of the resonance at the level and its standard deviation, Hz, shape (n,).

    Raises
    ------
    ValueError
        Naming the column, for what is no array of n finite numbers.
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
        object.__setattr__(self, "amplitude", first)
        object.__setattr__(self, "_notes", ())
        for name, values in given.items():
            object.__setattr__(self, name, optional_array(values, name, len(first), _EACH))

    @classmethod
    def read(cls, path: Path, *, use_inner_reversals: bool = False,
             assemblies: Optional[str] = None) -> Levels:  # fmt: skip
        """The levels of a levels.csv, see docs/file_formats.md.

        Parameters
        ----------
        path : path-like
            Of the file.
        use_inner_reversals : bool
            Whether to take levels whose joint turns more than twice a cycle (column ``reversals``):
            their D is not that of one loop. Without it they are left out, and a warning says so.
        assemblies : {"none"}, optional
            Says that all levels are of one joint although a column ``assembly`` names several.

        Raises
        ------
        FileError, FormatError, ValueError
            Where it cannot be read, or a cell breaks its rule.
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
    def of(cls, table: Any) -> Levels:
        """Levels of a pandas frame or a mapping.

        Parameters
        ----------
        table : DataFrame or mapping
            With columns ``amplitude`` and ``dissipation``, and others as of the class. A unit may
            stand behind a name as in levels.csv, ``amplitude [m]``; another than SI is refused.
        """
        if isinstance(table, Levels):
            return table
        if not isinstance(table, Mapping) and not hasattr(table, "columns"):
            raise InputError(f"table = {type(table).__name__}; must be a DataFrame or a mapping")
        columns = {}
        keys = [str(key) for key in table.keys()]
        resonance = any(key.partition(" [")[0] == "resonance_frequency" for key in keys)
        for key in table.keys():
            name, _, unit = str(key).partition(" [")
            if resonance and name.startswith("frequency"):
                continue  # of the drive
            name = name.removeprefix("resonance_")
            if name not in _UNITS:
                continue
            if unit and unit != _UNITS[name] + "]":
                raise InputError(
                    f"{key} is in another unit; must be in {_UNITS[name]}."
                    " Convert it, or write a levels.csv, which Levels.read converts"
                )
            columns[name] = table[key]
        for needed in ("amplitude", "dissipation"):
            if needed not in columns:
                raise InputError(f"{needed} is missing; must be a column of the table")
        return cls(**columns)

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with the columns of levels.csv."""
        import pandas

        return pandas.DataFrame(
            {f"{name} [{_UNITS[name]}]": values for name, values in self._columns().items()
             if values is not None}  # fmt: skip
        )

    def plot(self, ax: Optional[Axes] = None, **style: Any) -> Axes:
        """Draws D over A on logarithmic axes, by matplotlib."""
        from ._plot import plot_levels

        return plot_levels(self, ax, **style)

    def __len__(self) -> int:
        return len(self.amplitude)

    def _columns(self) -> dict[str, Optional[RealArray]]:
        return {name: getattr(self, name) for name in _UNITS}

    def _facts(self) -> tuple[str, list[tuple[str, str]]]:
        rows = [("levels", str(len(self)))]
        for name, values in self._columns().items():
            if values is not None:
                rows.append((name, f"{si(values.min(), '1')} to {si(values.max(), _UNITS[name])}"))
        return "Levels", rows
