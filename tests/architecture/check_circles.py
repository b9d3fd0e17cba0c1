"""Fails where units of C++ include each other in a circle, or where modules of Python import each other so.

Usage: check_circles.py ROOT units|modules

A unit is a source with the header of its name, below src/microslip and apps: it needs what either of them includes.
A module of the package of Python needs what any of its import statements names, be it in a function, which hides a
circle from the interpreter, or for annotations alone.

Circles are printed as chains, an arrow a line with its place, until each unit or module that is on a circle has been
on one of them.
"""

from __future__ import annotations

import argparse
import ast
import re
import sys
from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple, Optional


class Arrow(NamedTuple):
    """What a unit or module needs, and where a file says so."""

    to: str
    place: str  #: file:line
    words: str  #: "includes FILE" or "imports MODULE"


#: The arrows from each unit or module, by what they lead to.
Graph = dict[str, dict[str, Arrow]]

_INCLUDE = re.compile(r'\s*#\s*include\s*"([^"]+)"')


def units(root: Path) -> Graph:
    """Units by the path of their files without the ending."""
    files = [
        file
        for top in ("src/microslip", "apps")
        for file in sorted((root / top).rglob("*"))
        if file.suffix in (".c", ".cpp", ".h", ".hpp")
    ]
    unit_of = {file: file.relative_to(root).with_suffix("").as_posix() for file in files}
    graph: Graph = {unit: {} for unit in unit_of.values()}
    for file, unit in unit_of.items():
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            include = _INCLUDE.match(line)
            header = _included(include[1], file, root) if include else None
            if header in unit_of and unit_of[header] != unit:
                to, words = unit_of[header], f"includes {header.relative_to(root).as_posix()}"
                place = f"{file.relative_to(root).as_posix()}:{number}"
                graph[unit].setdefault(to, Arrow(to, place, words))
    return graph


def _included(header: str, by: Path, root: Path) -> Optional[Path]:
    """The file that is meant: beside the one that includes it, from a folder above that, or from src."""
    folders = [folder for folder in by.parents if root in folder.parents]
    candidates = (folder / header for folder in [*folders, root / "src"])
    return next((file for file in candidates if file.is_file()), None)


def modules(root: Path) -> Graph:
    """Modules by their full name, the compiled one by its interface file `_core.pyi`."""
    package = root / "src/microslip/bindings/python/microslip"
    files = [file for file in sorted(package.rglob("*")) if file.suffix in (".py", ".pyi")]
    module_of = {}
    for file in files:
        parts = file.relative_to(package.parent).with_suffix("").parts
        module_of[file] = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
    graph: Graph = {module: {} for module in module_of.values()}
    for file, module in module_of.items():
        within = module if file.stem == "__init__" else module.rpartition(".")[0]
        for statement in ast.walk(ast.parse(file.read_bytes(), str(file))):
            for name in _imported(statement, within):
                to = name
                while to and to not in graph:  # a name in a module, or another package
                    to = to.rpartition(".")[0]
                if to and to != module:
                    place = f"{file.relative_to(root).as_posix()}:{statement.lineno}"
                    graph[module].setdefault(to, Arrow(to, place, f"imports {to}"))
    return graph


def _imported(statement: ast.AST, package: str) -> Iterator[str]:
    """Full names that a statement of a module of the package imports; none of another statement."""
    if isinstance(statement, ast.Import):
        yield from (alias.name for alias in statement.names)
    elif isinstance(statement, ast.ImportFrom):
        parts = package.split(".")
        above = parts[: len(parts) - statement.level + 1] if statement.level else []
        base = [*above, *filter(None, [statement.module])]
        yield from (".".join([*base, alias.name]) for alias in statement.names)


def circle_through(graph: Graph, start: str) -> list[Arrow]:
    """The shortest chain of arrows from there back to it; empty where there is none."""
    chains: dict[str, list[Arrow]] = {start: []}
    waiting = deque([start])
    while waiting:
        at = waiting.popleft()
        for arrow in graph[at].values():
            if arrow.to == start:
                return [*chains[at], arrow]
            if arrow.to not in chains:
                chains[arrow.to] = [*chains[at], arrow]
                waiting.append(arrow.to)
    return []


def circles(graph: Graph) -> list[list[Arrow]]:
    """Circles until each unit or module that is on a circle is on one of these."""
    found = []
    seen: set[str] = set()
    for start in sorted(graph):
        circle = [] if start in seen else circle_through(graph, start)
        if circle:
            found.append(circle)
            seen.update(arrow.to for arrow in circle)
    return found


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=Path)
    parser.add_argument("kind", choices=("units", "modules"))
    given = parser.parse_args()
    graph = (units if given.kind == "units" else modules)(given.root.resolve())
    if not graph:
        print(f"no {given.kind} below {given.root}")
        return 1
    found = circles(graph)
    for circle in found:
        print("a circle:", *(f"  {arrow.place} {arrow.words}" for arrow in circle), sep="\n")
    print(f"{len(graph)} {given.kind}, {sum(map(len, graph.values()))} arrows; circles: {len(found)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
