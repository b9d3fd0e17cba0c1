#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What calls from Python cost beside the work that they ask for.

    PYTHONPATH=build/release/python python3 bench/python_calls.py

Prints a Markdown table: processor time a call, the least of some repetitions, so that what else runs on
the machine hardly counts. Paths and joints are of the kind of the benchmark `joint_memory_path`, of which
the first line is to be compared with `microslip_bench --benchmark_filter=joint_memory_path`.
"""

import sys
import time

import numpy as np

import microslip

REPETITIONS = 15


def seconds(call, calls=1):
    """Processor time of a call."""
    least = float("inf")
    for _ in range(REPETITIONS):
        began = time.process_time()
        for _ in range(calls):
            call()
        least = min(least, time.process_time() - began)
    return least / calls


def joint_of_100_segments(rng):
    force = 0.5 * np.arange(101)
    density = 0.5 + rng.random(101)
    density *= 0.95 / np.trapz(density, force)
    return microslip.Joint(1.7e5, [microslip.PiecewiseLinear(force, density)])


def band_limited_path(rng, samples, largest):
    """64 tones, 20 to 100 cycles in 8192 samples."""
    at = np.arange(samples)
    path = np.zeros(samples)
    for amplitude, phase, cycles in zip(rng.normal(size=64), rng.random(64), 20 + 80 * rng.random(64)):
        path += amplitude * np.sin(2 * np.pi * (cycles / 8192 * at + phase))
    return path * (largest / abs(path).max())


def lines():
    """What, time of a call [s], that over what, unit, scale."""
    rng = np.random.default_rng(2014)
    joint = joint_of_100_segments(rng)
    count = 1_000_000
    path = band_limited_path(rng, count, 2.9e-4)
    core = microslip.Memory(joint)._core
    whole = seconds(lambda: joint.memory().march(path))
    bare = seconds(lambda: core.march(path))
    yield "`Memory.march`, 10⁶ samples", whole / count, "ns a sample", 1e9
    yield "of it outside of the compiled half", 1 - bare / whole, "%", 100
    yield "`Joint.dissipation`, 10⁶ amplitudes", seconds(lambda: joint.dissipation(abs(path))) / count, \
        "ns each", 1e9
    memory = joint.memory()
    memory.march(path[:1000])
    for name, call in (
        ("`Joint.force` of a number", lambda: joint.force(1e-4)),
        ("`Joint.dissipation` of a number", lambda: joint.dissipation(1e-4)),
        ("`Memory.trial`", lambda: memory.trial(1e-4)),
        ("`Memory.advance`", lambda: memory.advance(1e-4)),
    ):
        yield name, seconds(call, 20_000), "µs a call", 1e6
    harmonic = microslip.HarmonicForce(3, 128)
    harmonics = np.array([0, 1e-4, 0, 1e-5j])
    yield "`HarmonicForce.evaluate`, 3 harmonics, 128 samples", \
        seconds(lambda: harmonic.evaluate(joint, harmonics), 500), "µs a call", 1e6
    one_mode = microslip.Structure(
        [60.0], {"point": [1.0]}, damping_ratio=0.003,
        joints=[microslip.StructuralJoint(microslip.Joint.four_parameter(200, 1e6, -0.5, 0.5), [0.5])],
    )  # fmt: skip
    yield "`frequency_response`, one mode, 3 harmonics, 128 samples", seconds(
        lambda: microslip.frequency_response(one_mode, 5.0, 78, 104, harmonics=3, samples=128), 5), \
        "ms a curve", 1e3


def main():
    print("| what | measured | |\n|---|---|---|")
    for what, value, unit, scale in lines():
        print(f"| {what} | {value * scale:.3g} | {unit} |")
        sys.stdout.flush()


main()
