"""Fails where a folder of src/microslip includes headers of a folder that its USES do not name, or names one in vain.

Usage: check_uses.py ROOT

What a folder uses sees what that uses in turn, so that the compiler finds an undeclared arrow too; and it never misses
a header that nobody includes.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

_FOLDER = re.compile(r"microslip_add_folder\(\s*([^\s)]+)([^)]*)\)")
_INCLUDE = re.compile(r'^\s*#\s*include\s*"microslip/([^"]+)/[^"/]+"', re.MULTILINE)


def uses_of(root: Path) -> dict[str, set[str]]:
    """The folders that each folder names as its USES."""
    uses: dict[str, set[str]] = {}
    for file in sorted((root / "src/microslip").rglob("CMakeLists.txt")):
        text = re.sub(r"#.*", "", file.read_text(encoding="utf-8"))
        for folder, arguments in _FOLDER.findall(text):
            words = arguments.split()
            first = words.index("USES") + 1 if "USES" in words else len(words)
            ends = (i for i in range(first, len(words)) if words[i].isupper())
            uses[folder] = set(words[first : next(ends, len(words))])
    return uses


def included_by(root: Path, folder: str) -> dict[str, str]:
    """The other folders whose headers files of a folder include, each with the first of these files."""
    found: dict[str, str] = {}
    for file in sorted((root / "src/microslip" / folder).glob("*.[ch]pp")):
        for other in _INCLUDE.findall(file.read_text(encoding="utf-8")):
            if other != folder:
                found.setdefault(other, file.relative_to(root).as_posix())
    return found


def main() -> int:
    root = Path(sys.argv[1]).resolve()
    uses = uses_of(root)
    if not uses:
        print(f"no folders below {root}")
        return 1
    wrong = 0
    for folder, named in sorted(uses.items()):
        included = included_by(root, folder)
        for other in sorted(named - included.keys()):
            print(f"{folder} includes nothing of {other}: take it out of its USES")
        for other in sorted(included.keys() - named):
            print(f"{folder} includes headers of {other}, as {included[other]} does: name it in its USES")
        wrong += len(named ^ included.keys())
    print(f"{len(uses)} folders, {sum(map(len, uses.values()))} arrows; wrong: {wrong}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
