#!/usr/bin/env python3
"""One version everywhere, and one way to ask programs: versions.py ROOT BUILD VERSION PROGRAM...

VERSION is that of CMake's project. Asks each program for --version, --help and an option that there is not; reads the
changelogs, the packages' settings, and what EGL and GL say of themselves through anteroom-info.
"""

import datetime
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
VERSION = sys.argv[3]
PROGRAMS = [pathlib.Path(argument) for argument in sys.argv[4:]]
# Its other statuses are those of the program that it runs.
WRONG_USAGE = {"anteroom-run": 125}


def ask(program, *arguments):
    environment = os.environ | {"ANTEROOM_CACHE": "off", "EGL_PLATFORM": "surfaceless"}
    return subprocess.run(
        [program, *arguments], env=environment, capture_output=True, text=True, check=False, timeout=120
    )


class Programs(unittest.TestCase):
    def setUp(self):
        self.assertGreater(len(PROGRAMS), 0)

    def test_version(self):
        for program in PROGRAMS:
            with self.subTest(program.name):
                answer = ask(program, "--version")
                self.assertEqual((answer.returncode, answer.stdout), (0, f"{program.name} {VERSION}\n"), answer.stderr)

    def test_help(self):
        for program in PROGRAMS:
            with self.subTest(program.name):
                answer = ask(program, "--help")
                self.assertEqual((answer.returncode, answer.stderr), (0, ""))
                for option in ("--help", "--version"):
                    self.assertIn(option, answer.stdout)

    def test_wrong_usage(self):
        for program in PROGRAMS:
            with self.subTest(program.name):
                answer = ask(program, "--no-such-option")
                self.assertEqual(answer.returncode, WRONG_USAGE.get(program.name, 2), answer.stdout)
                self.assertNotEqual(answer.stderr, "")


class Libraries(unittest.TestCase):
    def test_strings(self):
        answer = ask(BUILD / "bin/anteroom-info", "--json")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        facts = json.loads(answer.stdout)
        self.assertEqual(facts["egl"]["version"], f"1.5 Anteroom {VERSION}")
        self.assertEqual({platform["version"] for platform in facts["platforms"]}, {f"1.5 Anteroom {VERSION}"})
        self.assertEqual(facts["gles"]["version"], f"OpenGL ES-CM 1.1 Anteroom {VERSION}")


class Packages(unittest.TestCase):
    def test_made_by_cmake(self):
        for name, line in {
            "CPackConfig.cmake": f'set(CPACK_PACKAGE_VERSION "{VERSION}")',
            "AnteroomConfigVersion.cmake": f'set(PACKAGE_VERSION "{VERSION}")',
            "anteroom.pc": f"Version: {VERSION}",
        }.items():
            self.assertIn(line, (BUILD / name).read_text().splitlines(), name)

    def test_changelogs(self):
        """The newest version is the project's, and both list the same versions with the same days."""
        ours = re.findall(r"^## (\S+), (\d{4}-\d\d-\d\d)$", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
        packages = (ROOT / "cmake/package/changelog").read_text()
        versions = re.findall(r"^anteroom \((\S+)\) ", packages, re.MULTILINE)
        days = [
            datetime.datetime.strptime(day, "%a, %d %b %Y").date().isoformat()
            for day in re.findall(r"^ -- .*>  (\w+, +\d+ \w+ \d+) ", packages, re.MULTILINE)
        ]
        self.assertEqual(ours[0][0], VERSION)
        self.assertEqual(ours, list(zip(versions, days)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
