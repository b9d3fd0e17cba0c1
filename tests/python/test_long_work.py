# SPDX-License-Identifier: MIT
"""Long work: progress, cancelling, Ctrl-C, threads, memory."""

import concurrent.futures
import gc
import os
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import microslip

A = np.geomspace(2e-6, 9e-5, 40)


@pytest.fixture
def dissipation():
    truth = microslip.Joint(1e5, [microslip.Uniform(0, 9, 1)])
    return truth.dissipation(A) * (1 + 0.01 * np.random.default_rng(2).normal(size=len(A)))


def test_listener_is_called_and_may_cancel(dissipation):
    reported = []
    microslip.identify(A, dissipation, stiffness=1e5, samples=4_000,
                       progress=lambda done, total: reported.append((done, total)))  # fmt: skip
    assert reported and all(0 <= done <= total == 4_000 for done, total in reported)
    assert [done for done, _ in reported] == sorted(done for done, _ in reported)
    with pytest.raises(microslip.Cancelled):
        microslip.identify(A, dissipation, stiffness=1e5, samples=200_000,
                           progress=lambda done, total: False)  # fmt: skip


def test_what_a_listener_raises_comes_out(dissipation):
    def fail(done, total):
        raise ZeroDivisionError("of the listener")

    with pytest.raises(ZeroDivisionError, match="of the listener"):
        microslip.identify(A, dissipation, stiffness=1e5, samples=200_000, progress=fail)
    with pytest.raises(ValueError, match="progress"):
        microslip.identify(A, dissipation, stiffness=1e5, progress=3)


def test_listener_runs_where_it_was_given(dissipation):
    threads = set()
    microslip.identify(A, dissipation, stiffness=1e5, samples=4_000,
                       progress=lambda *_: threads.add(threading.get_ident()) or True)  # fmt: skip
    assert threads == {threading.get_ident()}


def test_control_c_ends_long_work(dissipation):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        microslip.identify(A, dissipation, stiffness=1e5, samples=1_000_000)
    timer.join()


def test_control_c_ends_a_path_under_normal_load(joint):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    path = 1e-5 * np.sin(np.linspace(0, 1e4, 1_000_000))
    timer.start()
    with pytest.raises(KeyboardInterrupt):  # 1e11 steps of elements
        joint.loop(path, np.ones_like(path), elements=100_000)
    timer.join()


def test_the_interpreter_is_free_meanwhile(dissipation):
    turns = 0
    done = threading.Event()

    def work():
        microslip.identify(A, dissipation, stiffness=1e5, samples=4_000)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(1e-3):
        turns += 1
    thread.join()
    assert turns > 10


def test_threads_find_what_one_finds(structure):
    balance = microslip.HarmonicBalance(structure, harmonics=11)
    forces = np.linspace(1, 20, 16)
    alone = [balance.frequency_response(f, 40, 60) for f in forces]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        together = list(pool.map(lambda f: balance.frequency_response(f, 40, 60), forces))
    for one, other in zip(alone, together):
        assert np.array_equal(one.response, other.response)


@pytest.mark.skipif("asan" in os.environ.get("LD_PRELOAD", ""),
                    reason="the sanitizer keeps what was freed; test_leaks.py looks there")  # fmt: skip
def test_calls_leave_nothing_behind(joint, structure):
    # Resident memory, in pages, after a warm-up: 1e5 calls of each would show a byte a call.
    def pages():
        gc.collect()
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1])

    def calls(count):
        memory = joint.memory()
        path = np.linspace(0, 1e-5, 8)
        for i in range(count):
            memory.advance(1e-6 * (i % 7))
            memory.trial(1e-6)
            memory.copy()
            joint.force(path)
            joint.density
            microslip.Joint(1e5)
            try:
                memory.advance(float("nan"))
            except ValueError:
                pass

    calls(5_000)
    before = pages()
    calls(100_000)
    grown = (pages() - before) * os.sysconf("SC_PAGESIZE")
    # Seven calls a turn: a leak of 8 bytes in one of them would be 800 kB.
    assert grown < 400_000


def test_nothing_but_numpy_is_needed():
    code = """
        import sys
        for name in ("matplotlib", "pandas", "scipy"):
            sys.modules[name] = None
        import microslip
        joint = microslip.Joint(1e5, [microslip.Uniform(0, 10, 1)])
        assert joint.force(5e-5) == 3.75
        try:
            joint.plot()
        except microslip.Error as error:
            assert "matplotlib is missing" in str(error)
        else:
            raise AssertionError
    """
    subprocess.run([sys.executable, "-c", textwrap.dedent(code)], check=True)


def test_pictures(structure, joint, dissipation):
    pytest.importorskip("matplotlib").use("Agg")
    from matplotlib import pyplot

    found = microslip.identify(A, dissipation, stiffness=1e5, samples=20)
    curve = microslip.frequency_response(structure, 5.0, 40, 60)
    result = microslip.march(structure, np.linspace(0, 0.1, 200), {"drive": np.ones(200)})
    t = np.arange(8192) / 1024
    free = np.exp(-0.01 * 2 * np.pi * 50 * t) * np.cos(2 * np.pi * 50 * t)
    recording = microslip.Recording.of({"free": free}, {"free": "m"}, fs=1024.0)
    decay = microslip.ring_down(recording)
    levels = microslip.Levels(A, dissipation)
    for thing in (joint, found, curve, result, levels, recording, decay):
        ax = thing.plot()
        assert ax.get_xlabel().endswith("]") and ax.get_ylabel().endswith("]")
        assert thing.plot(ax=ax) is ax
        pyplot.close(ax.figure)


def test_pictures_have_bands_of_the_response(structure, dissipation):
    figures = pytest.importorskip("matplotlib.figure")
    draws = microslip.identify(A, dissipation, stiffness=1e5, samples=20).draws
    balance, asked = microslip.HarmonicBalance(structure), {"draws": draws, "samples": 40}
    of_response = balance.frequency_response(5.0, 40, 60, **asked)
    of_force = balance.constant_response(1e-5, 40, 60, **asked)  # its band is no response
    for curve, bands in ((of_response, 1), (of_force, 0)):
        assert isinstance(curve, microslip.ResponseBand)
        assert len(curve.plot(figures.Figure().subplots()).collections) == bands
