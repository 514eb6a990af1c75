#!/usr/bin/env python3
"""Checks that no function is longer than 60 lines: functions.py ROOT [--self-check]

In layer/ and gen/, from the first line of its signature to its closing brace. The formatter closes a block at the
indentation of the line that opens it: nothing else need be known of C++. A function that is a table, such as a switch
with one line a case, says so in a comment over it: "A table:".
"""

import pathlib
import re
import sys
import tempfile

MOST = 60
FOLDERS = ("layer", "gen")
# What opens a block that is no function.
OTHER = re.compile(r"(?:\} )?(?:if|else|for|while|switch|do|try|catch|case|default|namespace|struct|class|enum|union|extern)\b")


def indentation(line):
    return len(line) - len(line.lstrip())


def start_of(lines, opened):
    """The first line of the statement that ends with the brace of line `opened`."""
    first = opened
    while first > 0:
        before = lines[first - 1].strip()
        if not before or before.startswith(("#", "//")) or before.endswith((";", "{", "}", ":")) and not before.endswith("::"):
            break
        first -= 1
    return first


def functions(text):
    """(number of the first line, lines, whether it is a table) of every function and method."""
    lines = text.split("\n")
    for opened, line in enumerate(lines):
        if not line.endswith("{") or line.lstrip().startswith("//"):
            continue
        first = start_of(lines, opened)
        head = " ".join(part.strip() for part in lines[first : opened + 1])
        # What opens inside parentheses is part of a call, or of a table.
        if "(" not in head or head.count("(") != head.count(")") or OTHER.match(head) or head.endswith("= {"):
            continue
        margin = indentation(lines[first])
        closed = next((i for i in range(opened + 1, len(lines)) if lines[i].startswith(" " * margin + "}")), None)
        if closed is None:
            continue
        comment = first - 1
        while comment > 0 and lines[comment].strip().startswith("//"):
            comment -= 1
        table = any("A table:" in l for l in lines[comment:first])
        yield first + 1, closed - first + 1, table


def complaints(root):
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".cpp", ".h", ".c", ".inc"):
                continue
            for line, length, table in functions(path.read_text()):
                if length > MOST and not table:
                    yield f"{path.relative_to(root)}:{line}: a function of {length} lines; {MOST} are the most"


def self_check():
    body = "  x();\n"
    cases = [
        ("void f() {\n" + body * 58 + "}\n", 0),
        ("void f() {\n" + body * 59 + "}\n", 1),
        ("void f(int a,\n       int b) {\n" + body * 58 + "}\n", 1),
        ("// A table: a row each.\nvoid f() {\n" + body * 90 + "}\n", 0),
        ("class C {\n  void f() {\n" + "  " + ("  " + body) * 59 + "  }\n};\n", 1),
        ("struct S {\n" + "  int x;\n" * 90 + "};\n", 0),
        ("constexpr int k[] = {\n" + "  f(1),\n" * 90 + "};\n", 0),
        ("namespace n {\nvoid f() {\n  if (a) {\n" + "  " + body * 60 + "  }\n}\n}\n", 1),
        ("void f() {\n  g([] {\n" + ("  " + body) * 60 + "  });\n}\n", 1),
        ("constexpr auto k = table<T>({\n" + "  {1, [](int a) { return a; }},\n" * 90 + "});\n", 0),
    ]
    wrong = 0
    for text, expected in cases:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "layer" / "a.cpp"
            file.parent.mkdir()
            file.write_text(text)
            found = len(list(complaints(pathlib.Path(folder))))
        if found != expected:
            print(f"{found} complaints instead of {expected} about:\n{text[:60]}")
            wrong += 1
    return wrong


def main():
    if "--self-check" in sys.argv:
        return bool(self_check())
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found))
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
