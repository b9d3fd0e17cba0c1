"""Fails where a folder of C++ holds more units, a source with its header each, than a reader finds his way in.

Usage: check_room_sizes.py ROOT [MOST]
"""

import sys
from collections import Counter
from pathlib import Path

MOST = 30


def main() -> int:
    root = Path(sys.argv[1])
    most = int(sys.argv[2]) if len(sys.argv) > 2 else MOST
    units = {file.with_suffix("") for folder in ("src/microslip", "apps") for file in (root / folder).rglob("*.[ch]pp")}
    count = Counter(unit.parent.relative_to(root) for unit in units)
    large = {folder: number for folder, number in count.items() if number > most}
    for folder, number in sorted(large.items()):
        print(f"{folder}: {number} units, at most {most} may be there: lay some in folders by topic")
    print(f"{len(units)} units in {len(count)} folders, {max(count.values())} at most")
    return 1 if large else 0


if __name__ == "__main__":
    sys.exit(main())
