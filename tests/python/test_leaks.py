# SPDX-License-Identifier: MIT
"""Under the address sanitizer: 1e5 calls leave nothing behind."""

import os
import subprocess
import sys

import pytest

CALLS = """
import sys
import numpy as np
import microslip

joint = microslip.Joint(2.3e6, [microslip.PowerLaw(0.01, -0.5, 0.0, 80.0), microslip.Atoms([90.0], [0.15])])
structure = microslip.Structure([40.0], {"drive": [0.7]}, damping_ratio=0.01, static_attachments=0,
                                joints=[microslip.StructuralJoint(joint, [0.25])])
balance = microslip.HarmonicBalance(structure, accuracy=0)
amplitude = np.geomspace(1e-6, 4e-5, 12)
loss = joint.dissipation(amplitude)
memory = joint.memory()
path = np.linspace(0, 1e-5, 8)
for i in range(100_000):
    memory.advance(1e-6 * (i % 7))
    memory.trial(1e-6)
    memory.march(path)
    memory.copy()
    joint.force(path)
    joint.density
    try:
        memory.advance(float("nan"))
    except ValueError:
        pass
    if i % 1000 == 0:
        balance.solve(frequency=39.0, force=1.0, strict=False)
        structure.joints
        microslip.march(structure, [0.0, 0.01, 0.02], {"drive": [0.0, 1.0, 0.0]})
        microslip.identify(amplitude, loss, stiffness=2.3e6, strict=False)
        try:
            microslip.Joint.read("nothing.json")
        except microslip.FileError:
            pass
"""


def test_nothing_of_microslip_is_left():
    if "asan" not in os.environ.get("LD_PRELOAD", ""):
        pytest.skip("the module is not compiled with the address sanitizer")
    options = "detect_leaks=1:exitcode=0:fast_unwind_on_malloc=1"
    environment = {**os.environ, "ASAN_OPTIONS": options, "LSAN_OPTIONS": "exitcode=0:report_objects=0"}
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", CALLS], env=environment,
                          capture_output=True, text=True)  # fmt: skip
    assert done.returncode == 0, done.stderr
    # The interpreter holds much to its end, and what a module makes of itself when it is loaded.
    leaks = [leak for leak in done.stderr.split("\n\n")
             if " leak of " in leak and "_core" in leak and "PyInit__core" not in leak]  # fmt: skip
    assert not leaks, "\n\n".join(leaks[:5])
    assert "ERROR: AddressSanitizer" not in done.stderr
