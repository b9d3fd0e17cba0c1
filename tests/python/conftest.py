# SPDX-License-Identifier: MIT
"""What tests of the Python package share."""

import os
import pathlib
import subprocess

import numpy as np
import pytest

import microslip


@pytest.fixture
def joint():
    """A lap joint with all kinds of parts: a power law, a jump, an atom, an elastic remainder."""
    return microslip.Joint(
        2.3e6,
        [
            microslip.PowerLaw(0.01, -0.5, 0.0, 80.0),
            microslip.Uniform(20.0, 60.0, 0.2),
            microslip.Atoms([90.0], [0.15]),
        ],
    )


@pytest.fixture
def structure(joint):
    """Two modes, a joint between them, both points driven in turn."""
    return microslip.Structure(
        [40.0, 95.0],
        {"drive": [0.7, 0.4], "end": [0.3, -0.8]},
        damping_ratio=[0.002, 0.004],
        joints=[microslip.StructuralJoint(joint, [0.25, 0.6], "lap")],
        static_attachments=0,
    )


MODEL = """schema = "microslip.model/1"
[structure]
frequency_Hz = [40.0, 95.0]
damping_ratio = [0.002, 0.004]
static_attachments = 0
[[structure.point]]
name = "drive"
shape = [0.7, 0.4]
[[structure.point]]
name = "end"
shape = [0.3, -0.8]
[[joint]]
name = "lap"
file = "joint.json"
shape = [0.25, 0.6]
[excitation]
point = "drive"
"""


@pytest.fixture
def model(joint, tmp_path):
    """The same structure as a file."""
    joint.write(tmp_path / "joint.json")
    (tmp_path / "model.toml").write_text(MODEL)
    return tmp_path / "model.toml"


@pytest.fixture
def program(tmp_path):
    """Calls the program in a folder of its own; gives the columns of the CSV file that it writes."""
    path = os.environ.get("MICROSLIP_PROGRAM", "")
    if not pathlib.Path(path).is_file():
        pytest.skip("MICROSLIP_PROGRAM names no program")

    def call(*arguments):
        done = subprocess.run([path, *map(str, arguments)], cwd=tmp_path, capture_output=True,
                              text=True)  # fmt: skip
        assert done.returncode == 0, done.stderr

    return call


def as_printed(frequency):
    """Frequencies as the program's tables have them: with 15 digits, for they are no SI inside."""
    return np.array([float(f"{f:.15g}") for f in frequency])


def columns(path):
    """A CSV file by the names of its columns without units; texts stay."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    names = [cell.split(" [")[0].strip() for cell in lines[0].split(",")]
    rows = [line.split(",") for line in lines[1:]]

    def numbers(i):
        try:
            return np.array([float(row[i]) for row in rows])
        except ValueError:
            return [row[i] for row in rows]

    return {name: numbers(i) for i, name in enumerate(names)}
