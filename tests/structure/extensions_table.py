#!/usr/bin/env python3
"""The README's table of extensions is what the code lists, by name: extensions_table.py ROOT [--write]"""

import pathlib
import re
import sys

BEGIN = "<!-- extensions: made by tests/structure/extensions_table.py --write -->\n"
END = "<!-- end of extensions -->\n"
ROW = re.compile(r'^ANTEROOM_(?:\w+_)?EXTENSION\((\w+), "(.*)"\)$', re.MULTILINE)


def extensions(root):
    """Pairs of GL or EGL and the rows of their list, each a name and a purpose."""
    for prefix, folder in (("GL", "gl"), ("EGL", "egl")):
        yield prefix, ROW.findall((root / "layer" / folder / "extensions.inc").read_text())


def table(root):
    lines = []
    for prefix, rows in extensions(root):
        lines += [f"| {prefix}: {len(rows)} extensions | |", "|---|---|"]
        lines += [f"| `{prefix}_{name}` | {purpose} |" for name, purpose in rows]
        lines.append("")
    return "\n".join(lines)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    readme = root / "README.md"
    text = readme.read_text()
    for prefix, rows in extensions(root):
        if rows != sorted(rows):
            print(f"{prefix}'s list of extensions is not sorted by name")
            return 1
    if BEGIN not in text or END not in text:
        print("README.md has no place for the table of extensions")
        return 1
    before, rest = text.split(BEGIN, 1)
    made = before + BEGIN + "\n" + table(root) + "\n" + END + rest.split(END, 1)[1]
    if "--write" in sys.argv:
        readme.write_text(made)
    elif made != text:
        print("The README's table is not what the code lists: tests/structure/extensions_table.py . --write")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
