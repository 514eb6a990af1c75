#!/usr/bin/env python3
"""cmake/install_dependencies with other programs in the place of Debian's: dependencies.py SCRIPT"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv[1]).resolve()
# Beside ours, what the script needs of the system.
PATH = "/usr/bin:/bin"
FAKES = {
    # What is installed: the names in the file `installed`.
    "dpkg-query": 'for name; do grep -qx -- "$name" installed && echo "installed $name"; done',
    # What the release has: all but the names in `unknown`.
    "apt-cache": '! grep -qx -- "$2" unknown',
    "apt-get": 'echo "$*" >>calls',
    "sudo": '"$@"',
}


class Dependencies(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for name, text in FAKES.items():
            (self.folder / name).write_text(f"#!/bin/bash\n{text}\n")
            (self.folder / name).chmod(0o755)

    def run_script(self, *arguments, installed=(), unknown=()):
        for file, names in (("installed", installed), ("unknown", unknown), ("calls", ())):
            (self.folder / file).write_text("".join(f"{name}\n" for name in names))
        result = subprocess.run(
            ["bash", SCRIPT, *arguments], cwd=self.folder, env=os.environ | {"PATH": f"{self.folder}:{PATH}"},
            capture_output=True, text=True, check=False,
        )
        return result, (self.folder / "calls").read_text().splitlines()

    def names(self, purpose):
        return self.run_script(purpose, "--list")[0].stdout.split()

    def test_demos_need_less(self):
        demos, tests = set(self.names("demos")), set(self.names("tests"))
        self.assertLess(demos, tests)
        for name in ("chromium", "weston", "xvfb", "renderdoccmd", "libgtest-dev", "vulkan-validationlayers"):
            self.assertIn(name, tests - demos)

    def test_nothing_to_do(self):
        for purpose in ("demos", "tests"):
            result, calls = self.run_script(purpose, installed=self.names(purpose))
            self.assertEqual((result.returncode, calls), (0, []), result.stderr)

    def test_installs_what_is_missing(self):
        installed = [name for name in self.names("tests") if name not in ("cmake", "lintian")]
        result, calls = self.run_script(installed=installed)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(calls[0], "update -q")
        self.assertTrue(calls[1].endswith(" cmake lintian"), calls)

    def test_a_name_that_the_release_lacks(self):
        """It stops nothing, and is named; where it alone is missing, nothing is asked of the network."""
        names = self.names("tests")
        for absent, number in ((("renderdoccmd",), 0), (("renderdoccmd", "cmake"), 2)):
            installed = [name for name in names if name not in absent]
            result, calls = self.run_script(installed=installed, unknown=["renderdoccmd"])
            self.assertEqual((result.returncode, len(calls)), (0, number), result.stderr)
            self.assertIn("no such package: renderdoccmd", result.stdout)
            self.assertNotIn("renderdoccmd", "".join(calls))

    def test_wrong_usage(self):
        self.assertEqual(self.run_script("nonsense")[0].returncode, 2)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
