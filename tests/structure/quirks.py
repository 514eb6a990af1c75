#!/usr/bin/env python3
"""Checks that something asks for every row of layer/vulkan's table of driver faults: quirks.py ROOT"""

import pathlib
import re
import sys


def main():
    vulkan = pathlib.Path(sys.argv[1]) / "layer" / "vulkan"
    (table,) = vulkan.rglob("quirks.inc")
    members = re.findall(r"^QUIRK\((\w+),", table.read_text(), re.MULTILINE)
    sources = [p.read_text() for p in vulkan.rglob("*.cpp") if p.name != "quirks.cpp"]
    unused = [m for m in members if not any(re.search(rf"quirks(\(\)|_)\.{m}\b", text) for text in sources)]
    for member in unused:
        print(f"{table}: nothing asks for {member}")
    if not members:
        print(f"{table}: no rows are found")
    return bool(unused) or not members


if __name__ == "__main__":
    sys.exit(main())
