# SPDX-License-Identifier: MIT
"""Shared by the examples: style and folder of their pictures."""

import os
import sys
from pathlib import Path

if __name__ != "__main__" and not sys.flags.interactive and "ipykernel" not in sys.modules:
    os.environ.setdefault("MPLBACKEND", "Agg")  # without a screen

from matplotlib import pyplot

#: Of Okabe and Ito: distinguished by all.
BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#777777"

pyplot.rcParams.update({
    "figure.dpi": 110, "savefig.dpi": 160, "figure.constrained_layout.use": True,
    "font.size": 10, "axes.titlesize": 11, "axes.titlelocation": "left", "axes.labelcolor": "#333333",
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": "#888888",
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True,
    "lines.linewidth": 1.6, "legend.frameon": False, "legend.fontsize": 9,
    "axes.prop_cycle": pyplot.cycler(color=[BLUE, ORANGE, GREEN, RED, "#CC79A7", "#56B4E9"]),
})  # fmt: skip


def folder():
    """The folder of the pictures: the argument of the script, or `pictures`."""
    given = [argument for argument in sys.argv[1:2] if not argument.startswith("-")]
    path = Path(given[0] if given else "pictures")
    path.mkdir(parents=True, exist_ok=True)
    return path


def save(figure, name):
    path = folder() / name
    figure.savefig(path)
    print(f"picture: {path}")
