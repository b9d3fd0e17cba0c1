"""Fails where a document or a message has one of the retired words of retired_words.txt.

Usage: check_retired_words.py ROOT [LIST]

Searched are the prose and the shown output of README.md, CONTRIBUTING.md, docs/*.md, examples/*/README.md and of what is
unreleased in CHANGELOG.md; and the strings of src/**/*.{cpp,hpp,h,c}, apps/**, of the package of Python, its docstrings
among them, and of report/web/*.js. Code between backticks and strings without a blank are names of files, columns and
keys, which stay. Each place is printed with the phrase and the better word.
"""

from __future__ import annotations

import ast
import bisect
import fnmatch
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple


class Word(NamedTuple):
    """A retired word."""

    pattern: re.Pattern
    better: str


class Allowed(NamedTuple):
    """Files in which a phrase stays."""

    files: str
    pattern: re.Pattern


class Text(NamedTuple):
    """A text of a file, with the lines in which its pieces begin."""

    text: str
    starts: list[int]  #: places in the text, rising
    lines: list[int]  #: line of each

    def line_at(self, place: int) -> int:
        index = bisect.bisect_right(self.starts, place) - 1
        return self.lines[index]


def pattern_of(expression: str) -> re.Pattern:
    """A blank matches blanks and the end of a line, but no end of a paragraph."""
    return re.compile(re.sub(r"(?<!\\) (?![?*+{])", "[ ]+", expression), re.IGNORECASE)


def read_list(path: Path) -> tuple[list[Word], list[Allowed]]:
    words, exceptions = [], []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        fields = line.split("\t")
        if fields[0] == "allow" and len(fields) == 4:
            exceptions.append(Allowed(fields[1], pattern_of(fields[2])))
        elif fields[0] != "allow" and len(fields) == 2 and all(fields):
            words.append(Word(pattern_of(fields[0]), fields[1]))
        else:
            sys.exit(f"{path}:{number}: expected a pattern, a tab and the better word, or allow, files, phrase and reason")
    if not words:
        sys.exit(f"{path}: has no words")
    return words, exceptions


def paragraphs(lines: list[str], first: int = 1) -> Text:
    """Lines in one text; those that are empty end a paragraph."""
    text, starts, numbers = "", [], []
    for number, line in enumerate(lines, first):
        starts.append(len(text))
        numbers.append(number)
        text += (line if line.strip() else "\x01") + " "
    return Text(text, starts, numbers)


def prose_of(document: str) -> Text:
    """A document of Markdown without code, addresses and comments; blocks of text are what programs print."""
    document = re.sub(r"<!--.*?-->", lambda found: re.sub(r"[^\n]", "\x02", found.group()), document, flags=re.DOTALL)
    lines, fence = [], None
    for line in document.splitlines():
        mark = re.match(r" *(```+|~~~+)(\w*)", line)
        if mark and fence is None:
            fence = mark.group(2)
            lines.append("")
        elif mark and line.strip() == mark.group(1):
            fence = None
            lines.append("")
        elif fence is None:
            line = re.sub(r"(`+).+?\1", "\x02", line)
            lines.append(re.sub(r"\]\([^)]*\)", "]", line))
        else:
            lines.append(line if fence == "text" else "")
    return paragraphs(lines)


def unreleased(changelog: str) -> str:
    """The lines of the first section, at their places."""
    kept, section = [], 0
    for line in changelog.splitlines():
        section += line.startswith("## ")
        kept.append(line if section == 1 else "")
    return "\n".join(kept)


C_TOKEN = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(?P<d>[^()\s\\]{0,16})\((?P<raw>.*?)\)(?P=d)"|"(?P<text>(?:[^"\\\n]|\\.)*)"|'(?:[^'\\\n]|\\.)*'"""
    r"""|(?P<space>\s+)|(?P<digits>\d[\w'.]*)|\w+|.""",
    re.DOTALL,
)


def c_strings(source: str) -> Iterator[Text]:
    """Strings of C and C++, neighbours as one."""
    source = re.sub(r"(?m)^[ \t]*#[ \t]*include[^\n]*", "", source)
    text, starts, lines, line = "", [], [], 1
    for token in C_TOKEN.finditer(source):
        whole = token.group()
        piece = token.group("text") if token.group("text") is not None else token.group("raw")
        if piece is not None and not whole.startswith(("//", "/*")):
            starts.append(len(text))
            lines.append(line)
            text += re.sub(r"\\n", "\x01", piece)
        elif token.group("space") is None and not whole.startswith(("//", "/*")) and text:
            yield Text(text, starts, lines)
            text, starts, lines = "", [], []
        line += whole.count("\n")
    if text:
        yield Text(text, starts, lines)


JS_TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|'((?:[^'\\\n]|\\.)*)'|"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`""", re.DOTALL)


def js_strings(source: str) -> Iterator[Text]:
    for token in JS_TOKEN.finditer(source):
        text = next((group for group in token.groups() if group is not None), None)
        if text is not None:
            yield Text(text, [0], [source.count("\n", 0, token.start()) + 1])


def python_strings(source: str) -> Iterator[Text]:
    """Strings and docstrings; of a docstring, and of a string over several lines, each line has its place."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield paragraphs([re.sub(r"`+.+?`+", "\x02", line) for line in node.value.splitlines()], node.lineno)


def texts_of(root: Path) -> Iterator[tuple[str, Text]]:
    def files(*patterns: str) -> Iterator[tuple[str, str]]:
        for pattern in patterns:
            for path in sorted(root.glob(pattern)):
                if path.is_file():
                    yield path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")

    for name, document in files("README.md", "CONTRIBUTING.md", "docs/*.md", "examples/*/README.md"):
        yield name, prose_of(document)
    for name, changelog in files("CHANGELOG.md"):
        yield name, prose_of(unreleased(changelog))
    for folder in ("src", "apps"):
        for name, source in files(*(f"{folder}/**/*.{ending}" for ending in ("cpp", "hpp", "h", "c"))):
            for text in c_strings(source):
                yield name, text
    for name, source in files("src/microslip/bindings/python/**/*.py"):
        for text in python_strings(source):
            yield name, text
    for name, source in files("src/microslip/report/web/*.js"):
        for text in js_strings(source):
            yield name, text


def main(arguments: list[str]) -> int:
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    root = Path(arguments[0])
    words, exceptions = read_list(Path(arguments[1]) if len(arguments) == 2 else Path(__file__).with_name("retired_words.txt"))
    found, searched = [], 0
    for name, text in texts_of(root):
        if " " not in text.text.strip():
            continue
        searched += 1
        stays = [(match.start(), match.end()) for files, pattern in exceptions if fnmatch.fnmatch(name, files)
                 for match in pattern.finditer(text.text)]
        for pattern, better in words:
            for match in pattern.finditer(text.text):
                if not any(start <= match.start() and match.end() <= end for start, end in stays):
                    phrase = " ".join(match.group().split())
                    found.append((name, text.line_at(match.start()), phrase, better))
    for name, line, phrase, better in sorted(set(found)):
        print(f"{name}:{line}: \"{phrase}\"; better: {better}")
    print(f"{searched} texts, {len(words)} retired words: {len(set(found))} found")
    if not searched:
        print(f"nothing to search below {root}")
    return 1 if found or not searched else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
