"""check_circles.py finds circles, names the lines that make them, and is silent where there is none."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHECK = Path(__file__).with_name("check_circles.py")
PACKAGE = "src/microslip/bindings/python/microslip"


def check(kind: str, files: dict[str, str]) -> tuple[int, list[str]]:
    """Status and lines of the check of a tree that holds these files."""
    with tempfile.TemporaryDirectory() as root:
        for name, content in files.items():
            path = Path(root, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        done = subprocess.run([sys.executable, str(CHECK), root, kind], capture_output=True, text=True)
    assert not done.stderr, done.stderr
    return done.returncode, done.stdout.splitlines()


def check_units(files: dict[str, str]) -> tuple[int, list[str]]:
    return check("units", {f"src/microslip/{name}": content for name, content in files.items()})


def check_modules(files: dict[str, str]) -> tuple[int, list[str]]:
    return check("modules", {f"{PACKAGE}/{name}": content for name, content in files.items()})


def include(*headers: str) -> str:
    return "".join(f'#include "{header}"\n' for header in headers)


class Units(unittest.TestCase):
    def test_without_circle(self) -> None:
        files = {
            "io/a.cpp": include("microslip/io/a.hpp", "microslip/io/b.hpp", "generated.hpp"),
            "io/a.hpp": "#include <vector>\n" + include("microslip/io/b.hpp", "microslip/io/c.hpp"),
            "io/b.cpp": '// #include "microslip/io/a.hpp"\n' + include("microslip/io/b.hpp"),
            "io/b.hpp": include("microslip/io/c.hpp"),
            "io/c.hpp": "",
            "joint/a.hpp": include("microslip/io/a.hpp"),  # another a
        }
        self.assertEqual(check_units(files), (0, ["4 units, 4 arrows; circles: 0"]))

    def test_of_source_and_header(self) -> None:
        files = {
            "io/a.hpp": "",
            "io/a.cpp": "\n" + include("microslip/io/b.hpp"),
            "io/b.hpp": "#  include  \"microslip/io/a.hpp\" // for A\n",
        }
        self.assertEqual(check_units(files), (1, [
            "a circle:",
            "  src/microslip/io/a.cpp:2 includes src/microslip/io/b.hpp",
            "  src/microslip/io/b.hpp:1 includes src/microslip/io/a.hpp",
            "2 units, 2 arrows; circles: 1",
        ]))  # fmt: skip

    def test_shortest_chain_first_and_all_units(self) -> None:
        files = {
            "io/a.hpp": include("microslip/io/b.hpp", "microslip/io/c.hpp"),
            "io/b.hpp": include("microslip/io/c.hpp"),
            "io/c.cpp": include("microslip/io/a.hpp"),
            "io/c.hpp": "",
        }
        status, lines = check_units(files)
        self.assertEqual((status, lines), (1, [
            "a circle:",
            "  src/microslip/io/a.hpp:2 includes src/microslip/io/c.hpp",
            "  src/microslip/io/c.cpp:1 includes src/microslip/io/a.hpp",
            "a circle:",
            "  src/microslip/io/b.hpp:1 includes src/microslip/io/c.hpp",
            "  src/microslip/io/c.cpp:1 includes src/microslip/io/a.hpp",
            "  src/microslip/io/a.hpp:1 includes src/microslip/io/b.hpp",
            "3 units, 4 arrows; circles: 2",
        ]))  # fmt: skip

    def test_of_programs(self) -> None:
        files = {
            "apps/microslip/documents/a.cpp": include("a.hpp", "b.hpp"),
            "apps/microslip/documents/a.hpp": "",
            "apps/microslip/b.cpp": include("b.hpp", "documents/a.hpp"),
            "apps/microslip/b.hpp": "",
        }
        status, lines = check("units", files)
        self.assertEqual(status, 1)
        self.assertIn("  apps/microslip/b.cpp:2 includes apps/microslip/documents/a.hpp", lines)


class Modules(unittest.TestCase):
    def test_without_circle(self) -> None:
        files = {
            "__init__.py": "from ._a import A\nfrom .more import b\n",
            "_a.py": '"""from ._b import B"""\nimport numpy as np\nfrom . import _core\nfrom ._b import B\n',
            "_b.py": "from ._core import Core\n",
            "_core.pyi": "from ._types import Array\n",
            "_types.py": "",
            "more/__init__.py": "",
            "more/b.py": "from .. import _core\nfrom .._a import (\n    A,\n)\n",
        }
        self.assertEqual(check_modules(files), (0, ["7 modules, 8 arrows; circles: 0"]))

    def expect(self, of_a: str, of_b: str, line: int, name: str = "_b") -> None:
        place = f"{PACKAGE}/{name.replace('.', '/')}.py"
        status, lines = check_modules({"__init__.py": "", "more/__init__.py": "", "_a.py": of_a,
                                       f"{name.replace('.', '/')}.py": of_b})  # fmt: skip
        self.assertEqual((status, lines[:-1]), (1, [
            "a circle:",
            f"  {PACKAGE}/_a.py:1 imports microslip.{name}",
            f"  {place}:{line} imports microslip._a",
        ]))  # fmt: skip

    def test_plain(self) -> None:
        self.expect("from ._b import b", "from ._a import a", 1)

    def test_in_a_function(self) -> None:
        self.expect("from . import _b", "def f():\n    from ._a import a\n", 2)

    def test_for_annotations(self) -> None:
        self.expect("import microslip._b", "if TYPE_CHECKING:\n    from microslip._a import A\n", 2)

    def test_in_a_package(self) -> None:
        self.expect("from .more import b", "\nfrom .. import _a as a\n", 2, "more.b")

    def test_with_the_whole_package(self) -> None:
        status, lines = check_modules({"__init__.py": "from ._a import A\n", "_a.py": "import microslip\n"})
        self.assertEqual((status, lines[:-1]), (1, [
            "a circle:",
            f"  {PACKAGE}/__init__.py:1 imports microslip._a",
            f"  {PACKAGE}/_a.py:1 imports microslip",
        ]))  # fmt: skip


class Trees(unittest.TestCase):
    def test_without_files(self) -> None:
        for kind in ("units", "modules"):
            status, (line,) = check(kind, {"README.md": ""})
            self.assertEqual(status, 1)
            self.assertTrue(line.startswith(f"no {kind} below "))


if __name__ == "__main__":
    unittest.main()
