# SPDX-License-Identifier: MIT
"""Nothing is lost: copies, other joints, draws, files, threads, the end of the interpreter."""

import copy
import pickle
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import microslip
from conftest import MODEL

A = np.geomspace(1e-6, 4e-5, 40)


@pytest.fixture
def at_the_end(joint, tmp_path):
    """A model whose response is not measured where it is driven, and whose frequencies are uncertain."""
    joint.write(tmp_path / "joint.json")
    text = MODEL.replace("static_attachments = 0", "static_attachments = 0\nfrequency_std = [0.01]")
    (tmp_path / "model.toml").write_text(text + '[response]\npoint = "end"\n')
    return microslip.Structure.read(tmp_path / "model.toml")


def peak(structure):
    return microslip.frequency_response(structure, 0.5, 45, 55).peaks.response[0]


@pytest.mark.parametrize("keep", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s)),
                                  lambda s: s.with_joints([s.joints[0].joint]),
                                  lambda s: s.with_joints(s.joints)])  # fmt: skip
def test_copies_measure_at_the_same_point(at_the_end, keep):
    assert peak(keep(at_the_end)) == peak(at_the_end)


def test_spread_of_a_model_counts_in_draws(at_the_end):
    band = microslip.HarmonicBalance(at_the_end).frequency_response(0.5, 45, 55, samples=60)
    assert (band.lower < band.upper).any()
    kept = microslip.HarmonicBalance(pickle.loads(pickle.dumps(at_the_end)))
    assert np.array_equal(kept.frequency_response(0.5, 45, 55, samples=60).upper, band.upper)


def test_a_damping_given_in_the_structure_stays(structure, joint):
    said = structure.with_joints([microslip.StructuralJoint(joint, [0.25, 0.6], "lap",
                                                            linear_damping=2e3)])  # fmt: skip
    for joints in ([joint], [said.joints[0].joint], said.joints,
                   [microslip.IdentifiedJoint(joint, 7.0)]):  # fmt: skip
        assert said.with_joints(joints).joints[0].linear_damping == 2e3


@pytest.mark.filterwarnings("ignore:damping_as_viscous")
def test_energies_of_a_march_add_up(structure, joint):
    damped = structure.with_joints([microslip.StructuralJoint(joint, [0.25, 0.6], "lap",
                                                              linear_damping=2e3)])  # fmt: skip
    t = np.linspace(0, 0.2, 2001)
    energy = microslip.march(damped, t, {"drive": 30 * np.sin(300 * t)}).energy
    assert energy.joint_linear_dissipation > 0
    spent = (energy.kinetic + energy.elastic + energy.linear_dissipation + energy.joint_dissipation
             + energy.joint_stored + energy.joint_linear_dissipation)  # fmt: skip
    assert spent == pytest.approx(energy.initial + energy.input, rel=1e-4)  # as a march must balance


def test_a_vibration_beyond_the_levels_warns(structure, joint):
    known = structure.with_joints([microslip.IdentifiedJoint(joint, None, 1.0)])
    balance = microslip.HarmonicBalance(known)
    with pytest.warns(microslip.MicroslipWarning, match="beyond"):
        found = balance.solve(response=1e-5, phase_lag=np.pi / 2)
    assert found.warnings


def test_frequencies_that_no_curve_has_are_refused(structure):
    balance = microslip.HarmonicBalance(structure, frequencies=[900.0])
    with pytest.raises(ValueError, match="frequencies = 900"):
        balance.frequency_response(0.5, 45, 55)
    with pytest.raises(ValueError, match="frequencies"):
        balance.backbone([1e-6])


def test_levels_are_written_whole(tmp_path, joint):
    loss = joint.dissipation(A)
    levels = microslip.Levels(A, loss, loss / 50, linear_dissipation=loss / 10, frequency=A + 30,
                              frequency_std=0 * A + 0.1)  # fmt: skip
    levels.write(tmp_path / "levels.csv")
    read = microslip.Levels.read(tmp_path / "levels.csv")
    for name in ("linear_dissipation", "frequency", "frequency_std"):
        assert np.allclose(getattr(read, name), getattr(levels, name), rtol=1e-14)
    assert "linear_dissipation [J]" in (tmp_path / "levels.csv").read_text()


def test_warnings_of_a_reader_are_in_the_result(tmp_path, joint):
    loss = joint.dissipation(A)
    rows = "\n".join(f"{a!r},{d!r},{4 if i < 3 else 2}" for i, (a, d) in enumerate(zip(A.tolist(), loss.tolist())))
    (tmp_path / "levels.csv").write_text("amplitude [m],dissipation [J],reversals [1]\n" + rows + "\n")
    with pytest.warns(microslip.MicroslipWarning, match="levels_left_out"):
        levels = microslip.Levels.read(tmp_path / "levels.csv")
    with pytest.warns(microslip.MicroslipWarning, match="levels_left_out"):
        found = microslip.identify(levels, stiffness=2.3e6, strict=False)
    assert "levels_left_out" in [note.code for note in found.warnings]
    found.write(tmp_path / "joint.json")
    assert "levels_left_out" in (tmp_path / "joint.json").read_text()


@pytest.mark.filterwarnings("ignore::microslip.MicroslipWarning")
def test_draws_keep_their_origin(tmp_path, joint):
    draws = microslip.identify(A, joint.dissipation(A), stiffness=2.3e6, samples=20, strict=False).draws
    draws.write(tmp_path / "a.h5")
    pickle.loads(pickle.dumps(draws)).write(tmp_path / "b.h5")
    assert (tmp_path / "a.h5").read_bytes() == (tmp_path / "b.h5").read_bytes()


def test_a_memory_is_of_one_thread_at_a_time(joint):
    memory = joint.memory()
    path = 5e-5 * np.sin(np.linspace(0, 3e3, 2_000_000))
    refused = []
    done = threading.Event()

    def work():
        memory.march(path)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(1e-4):
        for use in (memory.reset, memory.copy, lambda: memory.march(path), lambda: memory.force,
                    lambda: memory.trial(0.0)):  # fmt: skip
            try:
                use()
            except ValueError as error:
                refused.append(str(error))
    thread.join()
    assert refused and all("two threads" in text for text in refused)


def test_a_daemon_thread_does_not_crash_the_end():
    code = """
        import threading, time
        import numpy as np
        import microslip
        joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
        a = np.geomspace(2e-6, 9e-5, 40)
        def work():
            microslip.identify(a, joint.dissipation(a), stiffness=1e5, samples=500_000, strict=False)
        threading.Thread(target=work, daemon=True).start()
        time.sleep(0.4)
    """
    for _ in range(3):
        done = subprocess.run([sys.executable, "-W", "ignore", "-c", textwrap.dedent(code)],
                              capture_output=True, text=True, timeout=120)  # fmt: skip
        assert done.returncode == 0, done.stderr


@pytest.mark.filterwarnings("ignore::microslip.MicroslipWarning")
def test_draws_bring_their_linear_damping(structure, joint):
    loss = joint.dissipation(A) + 2e3 * A**2
    found = microslip.identify(A, loss, stiffness=2.3e6, samples=20, linear_damping=True, strict=False)
    draw = found.draws[3]
    assert draw.linear_damping == found.draws.linear_damping[3]
    assert structure.with_joints([draw]).joints[0].linear_damping == draw.linear_damping
    assert pickle.loads(pickle.dumps(draw)).linear_damping == draw.linear_damping
    assert draw.force(1e-5) == draw.joint.force(1e-5)
