#!/usr/bin/env python3
"""anteroom-info, and by it how ANTEROOM_DEVICE chooses: info.py TOOL [--any-time]"""

import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

TOOL = sys.argv[1]
ANY_TIME = "--any-time" in sys.argv
DRIVERS = sorted(pathlib.Path("/usr/share/vulkan/icd.d").glob("lvp_icd.*.json"))


def info(*arguments, status=0, **variables):
    environment = os.environ | {"ANTEROOM_CACHE": "off", "EGL_PLATFORM": "surfaceless"} | variables
    result = subprocess.run([TOOL, *arguments], env=environment, capture_output=True, text=True, check=False, timeout=1200)
    assert result.returncode == status, f"{result.returncode}\n{result.stdout}{result.stderr}"
    return result


class Info(unittest.TestCase):
    def test_text(self):
        shown = info().stdout
        for part in ("libEGL.so.1", ": chosen\n", "because", "1.5 Anteroom", "EGL_KHR_create_context", "Platform default",
                     "surfaces", "OpenGL ES-CM 1.1", "GL_OES_framebuffer_object", "MAX_TEXTURE_UNITS"):
            self.assertIn(part, shown)
        self.assertLess(len(info("--brief").stdout.splitlines()), 40)

    def test_json(self):
        facts = json.loads(info("--json").stdout)
        self.assertEqual(facts["gles"]["vendor"], "Anteroom")
        self.assertEqual(len([line for line in facts["device"]["found"] if line.endswith(": chosen")]), 1)
        self.assertEqual(facts["device"]["cache"], "none: switched off")
        self.assertIn("GL_OES_draw_texture", facts["gles"]["extensions"])
        self.assertEqual(facts["gles"]["limits"]["MAX_LIGHTS"], "8")
        self.assertGreater(len(facts["platforms"][0]["configs"]), 10)

    def test_cache(self):
        with tempfile.TemporaryDirectory() as folder:
            shown = info("--brief", ANTEROOM_CACHE_DIR=folder, ANTEROOM_CACHE="on").stdout
            self.assertIn(f"{folder}/anteroom.db", shown)

    def test_wrong_options(self):
        result = subprocess.run([TOOL, "--nonsense"], capture_output=True, text=True, check=False)
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("--nonsense", result.stderr)

    def test_no_such_device(self):
        for wanted in ("99", "no such name"):
            complaint = info("--brief", status=1, ANTEROOM_DEVICE=wanted).stderr
            self.assertIn(f"matches ANTEROOM_DEVICE={wanted}; there are:\n0: ", complaint)

    def test_no_driver(self):
        complaint = info("--brief", status=1, VK_ICD_FILENAMES="/nowhere.json", VK_DRIVER_FILES="/nowhere.json").stderr
        self.assertIn("install a Vulkan driver", complaint)

    @unittest.skipUnless(DRIVERS, "lavapipe is not installed")
    def test_device(self):
        """Two devices: the same driver, and a copy of it."""
        with tempfile.TemporaryDirectory() as folder:
            manifest = json.loads(DRIVERS[0].read_text())
            path = manifest["ICD"]["library_path"]
            found = next(place for place in (pathlib.Path(path), *pathlib.Path("/usr/lib").glob(f"*/{path}")) if place.is_file())
            manifest["ICD"]["library_path"] = shutil.copy(found, folder)
            copy = pathlib.Path(folder) / "copy.json"
            copy.write_text(json.dumps(manifest))
            files = f"{DRIVERS[0]}:{copy}"

            def devices(wanted):
                facts = json.loads(info("--json", VK_ICD_FILENAMES=files, VK_DRIVER_FILES=files, ANTEROOM_DEVICE=wanted).stdout)
                return [line.rsplit(": ", 1)[1] for line in facts["device"]["found"]], facts["device"]["because"]

            later, other = "as good, but listed later", "not what ANTEROOM_DEVICE asks for"
            self.assertEqual(devices("")[0], ["chosen", later])
            self.assertRegex(devices("")[1], "^discrete GPUs come first")
            self.assertEqual(devices("0"), (["chosen", other], "ANTEROOM_DEVICE=0"))
            self.assertEqual(devices("1"), ([other, "chosen"], "ANTEROOM_DEVICE=1"))
            self.assertEqual(devices("llvmpipe")[0], ["chosen", later])
            self.assertRegex(devices("llvmpipe")[1], "^ANTEROOM_DEVICE=llvmpipe; of those that match it ")

    @unittest.skipIf(ANY_TIME, "a sanitizer takes its time")
    def test_quick(self):
        """Under 150 ms of processor time, by the best of ten: others may be using the machine."""

        def spent():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime

        best = 1
        for _ in range(10):
            start = spent()
            info()
            best = min(best, spent() - start)
        print(f"anteroom-info: {best * 1000:.0f} ms")
        self.assertLess(best, 0.150)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
