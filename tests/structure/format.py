#!/usr/bin/env python3
"""Checks that the C++ sources are formatted as .clang-format says: format.py ROOT CLANG_FORMAT

clang-format takes any other file for C++ and destroys it: run it on these alone.
"""

import pathlib
import subprocess
import sys

from includes import sources


def main():
    root, clang_format = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    files = [path.relative_to(root).as_posix() for path in sources(root) if path.suffix != ".inl"]
    result = subprocess.run(
        [clang_format, "--dry-run", "--Werror", *files], cwd=root, capture_output=True, text=True, check=False
    )
    bad = sorted({line.split(":")[0] for line in result.stderr.splitlines() if "-Wclang-format-violations" in line})
    for name in bad:
        print(f"{name} is not formatted: clang-format -i {name}")
    if result.returncode != 0 and not bad:
        print(result.stderr)
    return result.returncode


if __name__ == "__main__":
    sys.exit(main())
