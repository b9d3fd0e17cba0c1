# SPDX-License-Identifier: MIT
"""Runs the Python blocks of a document, in order, in one session; what each prints goes to its file.

    run_python.py DOCUMENT (LINE BLOCK PRINTED)...

Says at which line of the document a block ends by an exception that the document does not show.
"""

import contextlib
import io
import sys
import traceback


def run(document, line, block, printed, names):
    with open(block, encoding="utf-8") as file:
        source = "\n" * line + file.read()  # lines are counted as in the document
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said):
            exec(compile(source, document, "exec"), names)
    except Exception:  # whatever it is, the reader would see it
        traceback.print_exc()
        sys.exit(f"{document}:{line}: this block ended by an exception")
    finally:
        with open(printed, "w", encoding="utf-8") as file:
            file.write(said.getvalue())


def main():
    document, *blocks = sys.argv[1:]
    names = {"__name__": "__main__"}
    for line, block, printed in zip(*[iter(blocks)] * 3):
        run(document, int(line), block, printed, names)


main()
