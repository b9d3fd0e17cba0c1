"""check_uses.py names dead and undeclared arrows between folders, and is silent where there is none."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).with_name("check_uses.py")
FILES = {
    "base/CMakeLists.txt": "microslip_add_folder(\n  base\n  LINKS fmt::fmt\n  PUBLIC\n    a.hpp)\n",
    "base/a.hpp": "",
    "io/bytes/CMakeLists.txt": "microslip_add_folder(\n  io/bytes\n  USES base # io/cells\n  WAS io)\n",
    "io/bytes/b.hpp": "",
    "io/bytes/b.cpp": '#include "microslip/base/a.hpp"\n#include "microslip/io/bytes/b.hpp"\n',
    "joint/CMakeLists.txt": "microslip_add_folder(\n  joint\n  LIGHT\n  USES base\n      io/bytes)\n",
    "joint/c.cpp": '// of "microslip/signal/d.hpp"\n#include <vector>\n#include "microslip/base/a.hpp"\n',
    "joint/c.hpp": '#include "microslip/io/bytes/b.hpp"\n',
}


def check(changed: dict[str, str]) -> tuple[int, list[str]]:
    """Status and lines of the check of FILES, some of which are changed."""
    with tempfile.TemporaryDirectory() as root:
        for name, content in {**FILES, **changed}.items():
            path = Path(root, "src/microslip", name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        done = subprocess.run([sys.executable, str(CHECK), root], capture_output=True, text=True)
    assert not done.stderr, done.stderr
    return done.returncode, done.stdout.splitlines()


class Uses(unittest.TestCase):
    def test_of_all_included(self) -> None:
        self.assertEqual(check({}), (0, ["3 folders, 3 arrows; wrong: 0"]))

    def test_dead(self) -> None:
        status, lines = check({"joint/c.hpp": ""})
        self.assertEqual((status, lines[0]), (1, "joint includes nothing of io/bytes: take it out of its USES"))

    def test_undeclared(self) -> None:
        status, lines = check({"base/a.cpp": '#include "microslip/joint/c.hpp"\n'})
        self.assertEqual((status, lines[0]), (
            1, "base includes headers of joint, as src/microslip/base/a.cpp does: name it in its USES"))  # fmt: skip

    def test_without_folders(self) -> None:
        with tempfile.TemporaryDirectory() as root:
            done = subprocess.run([sys.executable, str(CHECK), root], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)


if __name__ == "__main__":
    unittest.main()
