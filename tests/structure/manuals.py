#!/usr/bin/env python3
"""Renders every manual page, and checks that pages and completions know the options: manuals.py FOLDER BIN MAN

FOLDER holds a folder a program, with the program's manual page and completions for bash and zsh; BIN holds the programs.
"""

import os
import pathlib
import re
import subprocess
import sys

# A request of the man macros that the renderer took for text.
RAW_REQUEST = re.compile(r"\.(?:TH|SH|SS|PP|TP|IP|RS|RE|B|I|BR|RB|RI|IR|BI|IB|nf|fi|br)\b")
SECTIONS = ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS")


def run(*command):
    environment = os.environ | {"LC_ALL": "C.UTF-8", "MANWIDTH": "80"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=60)


def rendered(man, page):
    """The page as a terminal shows it, and what is wrong with it."""
    result = run(man, "--warnings", "--encoding=UTF-8", "--local-file", page)
    faults = [f"cannot be rendered: status {result.returncode}"] if result.returncode else []
    faults += result.stderr.splitlines()
    lines = result.stdout.splitlines()
    faults += [f"is broken: {line.strip()}" for line in lines if RAW_REQUEST.search(line)]
    faults += [f"has no section {section}" for section in SECTIONS if section not in lines]
    return result.stdout, [f"{page.name} {fault}" for fault in faults]


def check(page, bin_folder, man):
    name = page.stem
    text, faults = rendered(man, page)
    known = {page.name: text}
    for completion in (f"{name}.bash", f"_{name}"):
        file = page.parent / "completion" / completion
        known[completion] = file.read_text() if file.is_file() else ""
    options = set(re.findall(r"(?<![-\w])--[a-z][-a-z]*", run(bin_folder / name, "--help").stdout))
    if not {"--help", "--version"} <= options:
        faults.append(f"{name} --help names only {sorted(options)}")
    for option in sorted(options):
        for where, words in known.items():
            if not re.search(rf"(?<![-\w]){option}(?![-\w])", words.replace("\u2010", "-")):
                faults.append(f"{where} does not know {option}")
    return faults


def main():
    folder, bin_folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    pages = sorted(folder.glob("*/*.1"))
    faults = [] if pages else [f"no manual pages below {folder}"]
    for page in pages:
        faults += check(page, bin_folder, sys.argv[3])
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
