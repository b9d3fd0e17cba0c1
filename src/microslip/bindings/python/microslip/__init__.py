# SPDX-License-Identifier: MIT
"""Friction models of jointed structures: identified from vibration measurements, and simulated.

Quantities are in SI throughout: m, N, N/m, J, Hz, kg. Functions take and return arrays; anything
that `numpy.asarray` converts to real numbers is accepted.

>>> import microslip
>>> joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
>>> joint.dissipation(1e-4)
0.0006666666666666666
"""

from ._core import version as __version__
from ._calibration import (
    CalibratedJoint,
    Calibration,
    Edge,
    JointLevels,
    JointPair,
    ModalLevels,
    calibrate,
)
from ._draws import JointDraws
from ._errors import (
    Cancelled,
    Error,
    FileError,
    FormatError,
    InputError,
    MicroslipWarning,
    NotConverged,
)
from ._harmonic_force import HarmonicForce, HarmonicResponse
from ._identification import Identification, Parameter, Verdict, identify
from ._joint import (
    Atoms,
    FourParameter,
    IdentifiedJoint,
    Joint,
    Memory,
    Moments,
    PiecewiseLinear,
    PowerLaw,
    Response,
    Uniform,
)
from ._levels import Levels
from ._march import JointMotion, MarchEnergy, MarchResult, PointMotion, march
from ._march_band import MarchBand, MarchedSignal, Statistic, march_band
from ._recordings import Axis, Channel, Recording, read_recordings, write_recordings
from ._records import Estimate, RecordFit, RecordIdentification, identify_records
from ._report import report
from ._results import Note, Summary
from ._rig import Measurement, Reduction, Rig, Verification, measure, reduce, verify
from ._ring_down import RingDown, RingDownLevels, RingDownSensor, ring_down
from ._spread import PeakBand, Spread
from ._structure import Base, Compliance, Modes, StructuralJoint, Structure, modes
from ._uff import recordings_from_uff
from ._vibration import (
    BackboneBand,
    HarmonicBalance,
    JointCycles,
    ResponseBand,
    ResponseCurve,
    Vibration,
    Vibrations,
    backbone,
    frequency_response,
)

__all__ = [
    "Atoms",
    "Axis",
    "BackboneBand",
    "Base",
    "CalibratedJoint",
    "Calibration",
    "Cancelled",
    "Channel",
    "Compliance",
    "Edge",
    "Error",
    "Estimate",
    "FileError",
    "FormatError",
    "FourParameter",
    "HarmonicBalance",
    "HarmonicForce",
    "HarmonicResponse",
    "Identification",
    "IdentifiedJoint",
    "InputError",
    "Joint",
    "JointCycles",
    "JointDraws",
    "JointLevels",
    "JointMotion",
    "JointPair",
    "Levels",
    "MarchBand",
    "MarchEnergy",
    "MarchResult",
    "MarchedSignal",
    "Measurement",
    "Memory",
    "MicroslipWarning",
    "ModalLevels",
    "Modes",
    "Moments",
    "NotConverged",
    "Note",
    "Parameter",
    "PeakBand",
    "PiecewiseLinear",
    "PointMotion",
    "PowerLaw",
    "RecordFit",
    "RecordIdentification",
    "Recording",
    "Reduction",
    "Response",
    "ResponseBand",
    "ResponseCurve",
    "Rig",
    "RingDown",
    "RingDownLevels",
    "RingDownSensor",
    "Spread",
    "Statistic",
    "StructuralJoint",
    "Structure",
    "Summary",
    "Uniform",
    "Verdict",
    "Verification",
    "Vibration",
    "Vibrations",
    "__version__",
    "backbone",
    "calibrate",
    "frequency_response",
    "identify",
    "identify_records",
    "march",
    "march_band",
    "measure",
    "modes",
    "read_recordings",
    "recordings_from_uff",
    "reduce",
    "report",
    "ring_down",
    "verify",
    "write_recordings",
]
