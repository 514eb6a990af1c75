#!/usr/bin/env python3
"""Checks what a shared library exports and needs: exports.py LIBRARY PREFIX [--exactly NAMES] [--not-needed NAME]...

Exit status 77 when the library is not there.
"""

import argparse
import pathlib
import re
import subprocess
import sys

COMMAND = re.compile(r"^ANTEROOM_COMMAND\((\w+)\)$", re.MULTILINE)
EGL_TABLE = "glAnteroomEglTable"  # by which libEGL reaches the implementation


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def exported(library):
    # A version's own symbol ("NAME A 0") is a label of the version script, not an export.
    for line in run("nm", "-D", "--defined-only", library).splitlines():
        *_, kind, name = line.split()
        if kind not in "Aa":
            yield name.split("@")[0]


def needed(library):
    for line in run("readelf", "-d", "-W", library).splitlines():
        if "(NEEDED)" in line:
            yield line[line.index("[") + 1 : line.rindex("]")]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("prefix")
    parser.add_argument("--exactly", type=pathlib.Path, help="a file of ANTEROOM_COMMAND(name): what it exports")
    parser.add_argument("--not-needed", action="append", default=[])
    arguments = parser.parse_args()
    if not arguments.library.exists():
        print(f"{arguments.library.name} is not built")
        return 77

    names = set(exported(arguments.library))
    faults = [f"exports {name}" for name in sorted(names) if not name.startswith(arguments.prefix)]
    if arguments.exactly:
        wanted = set(COMMAND.findall(arguments.exactly.read_text())) | {EGL_TABLE}
        faults += [f"does not export {name}" for name in sorted(wanted - names)]
        faults += [f"exports {name}, which no listed extension has" for name in sorted(names - wanted)]
    if not names:
        faults.append("exports nothing")
    for library in needed(arguments.library):
        faults += [f"needs {library}" for name in arguments.not_needed if name in library]
    for fault in faults:
        print(f"{arguments.library.name} {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
