#!/usr/bin/python3
"""Check that includes point down: tests/layout.py [ROOT]

The order of the folders stands in docs/developer/layout.md, from the ground up. Every include of a file of the
project is compared with it; each one that points up is printed. Ends with 1 if there is any, or if a folder has no
place in the list or a place has no folder.
"""

import pathlib
import re
import sys

MODULES = ("mpm", "beam", "coupling", "studies")
# Modules that must not know each other although one of them comes first.
STRANGERS = {("mpm", "beam"), ("beam", "mpm")}
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def listed_folders(root):
    text = (root / "docs/developer/layout.md").read_text(encoding="utf-8")
    return [line.split()[0] for line in text.split("```")[1].strip().splitlines()]


def problems(root):
    order = {folder: place for place, folder in enumerate(listed_folders(root))}
    files = [path.relative_to(root) for module in MODULES
             for pattern in ("*.h", "*.cc") for path in sorted((root / module).rglob(pattern))]
    found = {path.parent.as_posix() for path in files}
    yield from (f"{folder} has no place in docs/developer/layout.md" for folder in sorted(found - set(order)))
    yield from (f"{folder} of docs/developer/layout.md does not exist" for folder in sorted(set(order) - found))
    for path in files:
        here = path.parent.as_posix()
        for included in INCLUDE.findall((root / path).read_text(encoding="utf-8")):
            there = pathlib.PurePosixPath(included).parent.as_posix()
            if not (root / included).is_file():
                yield f"{path} includes {included}, which does not exist"
            elif (here.split("/")[0], there.split("/")[0]) in STRANGERS:
                yield f"{path} includes {included}: {here.split('/')[0]} must not know {there.split('/')[0]}"
            elif order.get(there, -1) > order.get(here, len(order)):
                yield f"{path} includes {included}: {there} is above {here}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    found = list(problems(root))
    print("\n".join(found) or "all includes point down")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
