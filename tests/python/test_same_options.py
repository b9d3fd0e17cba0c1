# SPDX-License-Identifier: MIT
"""Options that program, package and C have in common: names, choices, units, defaults and ranges.

docs/commands.md is the help of the program: the test package.command_reference says so."""

import ctypes
import inspect
import os
import pathlib
import re
from typing import Callable, NamedTuple, Optional

import pytest

import microslip

ROOT = pathlib.Path(__file__).parents[2]
HELP = (ROOT / "docs/commands.md").read_text().replace("\\", "")
HEADER = (ROOT / "src/microslip/bindings/c/microslip.h").read_text()


class Same(NamedTuple):
    """An option of the program that is a parameter of the package."""

    name: Optional[str] = None  # of the parameter, where it is not that of the option
    unit: Optional[str] = None  # that both texts name
    values: Optional[dict] = None  # parameter by text of the program, where these differ
    of: Optional[Callable] = None  # the function that has it, where another has one of its name
    wider: Optional[str] = None  # the range of the package, where the program keeps to a part of it


FIT = {"none": False, "fit": True}
SOUGHT = {"none": False, "sought": True}
FORCING = {"excitation": False, "modal": True}
NO = {None: True}  # a flag that takes away what the parameter has by default
SAME = Same()
DRAWN = {"draws": Same("samples"), "seed": SAME, "confidence": SAME, "correlation": SAME}
BALANCE = microslip.HarmonicBalance.__init__

# Per command the functions of the package, their options in common, and those of the program alone:
# files that a function of the package takes or returns as an object, and what its arguments say by
# themselves.
COMMANDS = {
    "identify": (
        [microslip.identify, microslip.identify_records, microslip.Levels.read],
        {
            "stiffness": Same(unit="N/m"),
            "method": SAME,
            "smoothing": SAME,
            "smoothing-unit": SAME,
            "linear-damping": Same(values=FIT),
            "inner-reversals": Same(
                "use_inner_reversals", values={"leave-out": False, "use": True}
            ),
            "edges": Same(values=SOUGHT),
            "atom": SAME,
            "fit": SAME,
            "samples": Same(of=microslip.identify),
            "seed": SAME,
            "dissipation-gain-std": SAME,
            "amplitude-gain-std": SAME,
            "loss-factor-std": SAME,
            "force": SAME,
            "displacement": SAME,
            "start": SAME,
            "viscous": Same(values=FIT),
            "drift": Same(values=FIT),
        },
        "density-csv samples-out bands assemblies assume-units allow-truncated rate",
    ),
    "frf": (
        [
            BALANCE,
            microslip.HarmonicBalance.frequency_response,
            microslip.HarmonicBalance.constant_response,
        ],
        {
            "harmonics": SAME,
            "samples": Same(of=BALANCE),
            "force": Same(unit="N"),
            "response": SAME,
            "accuracy": SAME,
            "at": Same("frequencies", unit="Hz"),
            **DRAWN,
        },
        "acceleration frequency peaks-csv",
    ),
    "backbone": (
        [BALANCE, microslip.HarmonicBalance.backbone],
        {
            "harmonics": SAME,
            "samples": Same(of=BALANCE),
            "response": SAME,
            "mode": Same(values={"1": 0}),
            "forcing": Same("modal_forcing", values=FORCING),
            **DRAWN,
        },
        "",
    ),
    "march": (
        [microslip.march, microslip.march_band],
        {
            "step": Same(unit="s"),
            "every": SAME,
            "no-error-estimate": Same("estimate_error", values=NO),
            "normal-load-law": Same("law"),
            "elements": SAME,
            **DRAWN,
        },
        "force-file release duration sampling-rate peaks-csv",
    ),
    "calibrate": (
        [microslip.calibrate],
        {
            "frequency": SAME,
            "stiffness": Same("fit_stiffness", values={"given": False, "fit": True}),
            "shapes": SAME,
            "edges": Same(values=SOUGHT),
            "forcing": Same("modal_forcing", values=FORCING),
            "harmonics": SAME,
            "samples": SAME,
            "seed": SAME,
            "keep-samples": Same(values=NO),  # only the program writes them where nobody asks
        },
        "model-frequencies",
    ),
    "ringdown": (
        [microslip.ring_down, microslip.RingDown.levels, microslip.read_recordings],
        {
            "channel": SAME,
            "frequency": Same(unit="Hz"),
            "band": Same(unit="Hz"),
            "from": Same("from_", unit="s"),
            "to": Same(unit="s"),
            "assume-units": SAME,
            "allow-truncated": SAME,
            "rate": Same(unit="Hz"),
            "modal-mass": Same(unit="kg"),
            "joint-ratio": SAME,
            "loss-factor": SAME,
            "stick-frequency": Same(unit="Hz"),
            "joint-stiffness": Same(unit="N/m"),
        },
        "model sensor mode",
    ),
    "reduce": (
        [microslip.reduce, microslip.read_recordings],
        {
            "frequency": Same(unit="Hz"),
            "order": SAME,
            "modes": SAME,
            "no-vibrometer": Same("use_vibrometer", values=NO),
            "assume-units": SAME,
            "allow-truncated": SAME,
            "rate": Same(unit="Hz"),
            "skip-faulty": SAME,
        },
        "sensor force mode",
    ),
    "measure": (
        [microslip.measure],
        {"seed": SAME, "no-shaker": Same("shaker", values=NO), "before-control": SAME},
        "format",
    ),
    "verify": (
        [microslip.verify, microslip.read_recordings],
        {
            "modes": Same(wider="1 to 200"),
            "harmonics": SAME,
            "sine": SAME,
            "frequency": Same(unit="Hz"),
            "cycles": Same(wider="0 or more"),
            "no-vibrometer": Same("use_vibrometer", values=NO),
            "draws": Same("samples"),
            "seed": SAME,
            "confidence": SAME,
            "normal-load-std": SAME,
            "frequency-std": SAME,
            "loss-factor-std": SAME,
            "force-gain-std": SAME,
            "acceleration-gain-std": SAME,
            "assume-units": SAME,
            "allow-truncated": SAME,
            "rate": Same(unit="Hz"),
            "skip-faulty": SAME,
        },
        "harmonics-csv histories picture samples correlation kind sensor mode force displacement "
        "joint",
    ),
    "loop": (
        [microslip.Joint.loop],
        {"normal-load-law": Same("law"), "elements": SAME},
        "path amplitude points draws seed confidence samples normal-load-std",
    ),
}


def options_of(command):
    """The help of the options of a command, by name; not of those that all have."""
    section = re.search(rf"^## microslip {command}\n(.*?)(?=^## |\Z)", HELP, re.M | re.S).group(1)
    line = r"^\* (?:`-\w`, )?`--([\w-]+)[^`]*`(?:, required)?: (.*)$"
    found = dict(re.findall(line, section, re.M))
    return {name: text for name, text in found.items() if name not in ("help", "out", "quiet")}


def parameter_texts(function):
    """Type and text of each parameter in a docstring."""
    text = inspect.getdoc(function) or ""
    if function.__name__ == "__init__":
        text = inspect.getdoc(microslip.HarmonicBalance)
    found = {}
    entry = r"^(\w[\w, ]*?)(?: : (.*))?\n((?: .*\n|\n(?= ))+)"
    for names, kind, about in re.findall(entry, text.split("----------\n", 1)[-1] + "\n", re.M):
        for name in names.split(", "):
            found[name] = f"{kind}\n{about}"
    return found


def homes(command, option, pair):
    """The functions that have the parameter of an option, with its name."""
    name = pair.name or option.replace("-", "_")
    functions = COMMANDS[command][0] if pair.of is None else [pair.of]
    return [(f, name) for f in functions if name in inspect.signature(f).parameters]


CASES = [(command, option) for command, (_, same, _) in COMMANDS.items() for option in same]
every_option = pytest.mark.parametrize("command, option", CASES, ids=map(" ".join, CASES))


@pytest.mark.parametrize("command", COMMANDS)
def test_every_option_of_the_program_is_known_here(command):
    _, same, alone = COMMANDS[command]
    assert sorted([*same, *alone.split()]) == sorted(options_of(command))


@every_option
def test_names(command, option):
    assert homes(command, option, COMMANDS[command][1][option])


def in_si(text):
    """A number of the program, "0.2%" too; other text as it is."""
    share = text.endswith("%")
    try:
        return float(text.rstrip("%")) / (100.0 if share else 1.0)
    except ValueError:
        return text


def default_of(text):
    """What the help states; None where that is a sentence."""
    stated = re.search(r"Default: (\S+?)\.(?: |$)|[,;] default (\d+)", text)
    return None if stated is None else stated[1] or stated[2]


@every_option
def test_defaults(command, option):
    pair = COMMANDS[command][1][option]
    stated = default_of(options_of(command)[option])
    wanted = {None, False, 0, 0.0, inspect.Parameter.empty} if stated is None else {in_si(stated)}
    if pair.values:
        wanted = {pair.values[stated]} if stated in pair.values else wanted
    for function, name in homes(command, option, pair):
        if pair.name == "samples" and stated is None and function is not microslip.verify:
            continue  # a number of draws has a default where draws are given
        assert inspect.signature(function).parameters[name].default in wanted, function


@every_option
def test_choices(command, option):
    pair = COMMANDS[command][1][option]
    stated = re.search(r"One of ([\w, -]+)\.", options_of(command)[option])
    if stated is None:
        return
    choices = set(stated[1].split(", "))
    if pair.values:
        assert choices == set(pair.values)
        return
    for function, name in homes(command, option, pair):
        about = parameter_texts(function).get(name, "")
        if "{" in about:  # else "As of" another function, which is looked at as well
            assert choices == set(re.findall(r'"([\w-]+)"', about.split("}")[0]))


@every_option
def test_units(command, option):
    pair = COMMANDS[command][1][option]
    if pair.unit is None:
        return
    unit = rf"(?<![\w/^*]){re.escape(pair.unit)}(?![\w/^*])"
    assert re.search(unit, options_of(command)[option])
    texts = [parameter_texts(f).get(name, "") for f, name in homes(command, option, pair)]
    assert any(re.search(unit, text) for text in texts)


@every_option
def test_ranges(command, option):
    pair = COMMANDS[command][1][option]
    stated = re.search(r"Allowed: from (\d+) to (\d+)\.", options_of(command)[option])
    if stated is None:
        return
    for function, name in homes(command, option, pair):
        assert (pair.wider or f"{stated[1]} to {stated[2]}") in parameter_texts(function)[name]


# ---- C ----

# Per struct the functions of the package, and members of another name.
STRUCTS = {
    "microslip_identify_options": ([microslip.identify], {"bands": "samples"}),
    "microslip_frf_options": ([BALANCE], {"at": "frequencies"}),
    "microslip_march_options": (
        [microslip.march],
        {"start_displacement": "displacement", "start_velocity": "velocity"},
    ),
}
# Of C alone: sizes, what the package does by itself, and what other functions of it have.
C_ALONE = {
    *("struct_size", "progress", "user", "command", "threads", "confidence"),
    *("at_count", "start_modes", "judge", "response"),
}
C_TYPES = {
    "size_t": ctypes.c_size_t,
    "double": ctypes.c_double,
    "int": ctypes.c_int,
    "uint64_t": ctypes.c_uint64,
    "const char *": ctypes.c_char_p,
    "const double *": ctypes.c_void_p,
    "void *": ctypes.c_void_p,
    "microslip_progress": ctypes.c_void_p,
    "microslip_response": ctypes.c_int,
}


def members_of(struct):
    """Type, name and comment of each."""
    body = re.search(rf"typedef struct {struct} {{\n(.*?)}} {struct};", HEADER, re.S).group(1)
    found = re.findall(r"^  ([\w ]+?[ *])(\w+); +/\*\*< (.*?) \*/$", body, re.M | re.S)
    return [(kind.strip(), name, " ".join(about.split())) for kind, name, about in found]


def defaults_in_c(struct):
    library = os.environ.get("MICROSLIP_C_LIBRARY", "")
    if not pathlib.Path(library).is_file():
        pytest.skip("MICROSLIP_C_LIBRARY names no library")
    fields = [(name, C_TYPES[kind]) for kind, name, _ in members_of(struct)]
    options = type(struct, (ctypes.Structure,), {"_fields_": fields})()
    size = ctypes.c_size_t(ctypes.sizeof(options))
    assert getattr(ctypes.CDLL(library), f"{struct}_defaults")(ctypes.byref(options), size) == 0
    return options


@pytest.mark.parametrize("struct", STRUCTS)
def test_c_has_the_defaults_of_the_package(struct):
    functions, renamed = STRUCTS[struct]
    options = defaults_in_c(struct)
    parameters = {k: v for f in functions for k, v in inspect.signature(f).parameters.items()}
    compared = 0
    for _, name, about in members_of(struct):
        if name in C_ALONE or "no default" in about:
            continue
        default = parameters[renamed.get(name, name)].default
        value = getattr(options, name)
        value = value.decode() if isinstance(value, bytes) else value
        assert (value or None) == (default or None) or (value, default) == ("none", None), name
        compared += 1
    assert compared > 5


@pytest.mark.parametrize("struct", STRUCTS)
def test_c_says_its_defaults(struct):
    options = defaults_in_c(struct)
    for kind, name, about in members_of(struct):
        if kind not in ("size_t", "double", "int", "uint64_t") or name in C_ALONE:
            continue
        if "no default" in about:
            continue
        named = re.search(r"(\d+) \(default\)", about)
        stated = named or re.search(r"([\de.-]+)(?:; needs W_lin)?$", about)
        assert float(stated[1]) == getattr(options, name), name
