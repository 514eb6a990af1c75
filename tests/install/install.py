#!/usr/bin/env python3
"""Installs into a folder, moves it and uses it; makes the Debian packages and installs them below another folder.

install.py BUILD_FOLDER SOURCE_FOLDER LIBDIR CMAKE VERSION SUITE

Nothing outside a temporary folder is written.
"""

import os
import pathlib
import re
import signal
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
LIBDIR, CMAKE, VERSION = sys.argv[3:6]
PROGRAM = SOURCE / "tests/install/program.c"
DRAWN = "EGL Anteroom, GL Anteroom, 0 255 0\n"
OURS = ("LD_LIBRARY_PATH", "LD_PRELOAD", "__EGL_VENDOR_LIBRARY_FILENAMES", "__EGL_VENDOR_LIBRARY_DIRS", "DESTDIR")


def run(*command, status=0, **more):
    environment = {name: value for name, value in os.environ.items() if name not in OURS}
    environment |= {"ANTEROOM_CACHE": "off", "LC_ALL": "C"} | more.pop("env", {})
    result = subprocess.run(
        [str(word) for word in command], env=environment, capture_output=True, text=True, check=False, timeout=1200, **more
    )
    assert result.returncode == status, f"{command}: {result.returncode}\n{result.stdout}{result.stderr}"
    return result


class Folder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name).resolve()


class Prefix(Folder):
    """cmake --install, to a prefix that is then moved."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run(CMAKE, "--install", BUILD, "--prefix", cls.folder / "first")
        cls.prefix = (cls.folder / "first").rename(cls.folder / "a moved prefix")
        cls.libraries = cls.prefix / LIBDIR / "anteroom"
        cls.runner = cls.prefix / "bin/anteroom-run"
        cls.vendor = cls.prefix / "share/glvnd/egl_vendor.d/90_anteroom.json"
        cls.program = cls.folder / "program"
        run("cc", PROGRAM, "-o", cls.program, "-lEGL", "-lGLESv1_CM")

    def test_uninstall(self):
        prefix = self.folder / "second"
        run(CMAKE, "--install", BUILD, "--prefix", prefix)
        other = prefix / "bin/other"
        other.touch()
        run(CMAKE, f"-DMANIFEST={BUILD / 'install_manifest.txt'}", "-P", SOURCE / "cmake/Uninstall.cmake")
        self.assertEqual([path for path in prefix.rglob("*") if not path.is_dir()], [other])
        self.assertEqual([path for path in prefix.rglob("*") if "anteroom" in path.name.lower()], [])

    def test_nothing_points_to_the_build(self):
        for path in [*self.libraries.iterdir(), *(self.prefix / "bin").iterdir()]:
            if path.read_bytes()[:4] != b"\x7fELF":
                continue
            for found in re.findall(r"R(?:UN)?PATH\).*\[(.*)\]", run("readelf", "-dW", path).stdout):
                for folder in found.split(":"):
                    self.assertTrue(folder.startswith("$ORIGIN"), f"{path}: {found}")
        for path in self.prefix.rglob("*"):
            if path.suffix in (".cmake", ".pc", ".json"):
                self.assertNotIn(str(BUILD), path.read_text())
                self.assertNotIn(str(self.folder), path.read_text())

    def test_one_copy(self):
        self.assertEqual(os.readlink(self.libraries / "libGLESv1_CM.so.1"), "libanteroom.so.0")

    def test_pkg_config(self):
        flags = run(
            "pkg-config", "--cflags", "--libs", "anteroom", env={"PKG_CONFIG_PATH": str(self.prefix / LIBDIR / "pkgconfig")}
        ).stdout.replace("\\ ", "\0").split()
        program = self.folder / "by_pkg_config"
        run("cc", PROGRAM, "-o", program, *(flag.replace("\0", " ") for flag in flags))
        self.assertEqual(run(program).stdout, DRAWN)
        # What is linked to us runs on others, too.
        self.assertIn("libGLESv1_CM.so.1", run("readelf", "-dW", program).stdout)

    def test_find_package(self):
        build = self.folder / "by_find_package"
        run(CMAKE, "-S", SOURCE / "tests/install/project", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
            f"-DWANTED={VERSION}")
        run(CMAKE, "--build", build)
        self.assertEqual(run(build / "program").stdout, DRAWN)

    def test_our_header(self):
        code = "#include <EGL/egl.h>\n#include <anteroom/eglanteroom.h>\nint name = EGL_DEVICES_ANTEROOM;\n"
        run("cc", "-x", "c", "-fsyntax-only", f"-I{self.prefix / 'include'}", "-", input=code)

    def test_vendor(self):
        self.assertEqual(run(self.program, env={"__EGL_VENDOR_LIBRARY_FILENAMES": str(self.vendor)}).stdout, DRAWN)

    def test_beside_others(self):
        """Behind Mesa by the order of names, and the one that is asked for by its device."""
        both = self.folder / "vendors"
        both.mkdir()
        theirs = list(pathlib.Path("/usr/share/glvnd/egl_vendor.d").glob("*_mesa.json"))
        if not theirs:
            self.skipTest("Mesa's EGL is not installed")
        shutil.copy(theirs[0], both)
        # Paths are relative to the file.
        library = self.libraries / "libEGL_anteroom.so.0"
        (both / self.vendor.name).write_text(re.sub(r'(path" : )"[^"]*"', rf'\1"{library}"', self.vendor.read_text()))
        shown = run(self.program, env={"__EGL_VENDOR_LIBRARY_DIRS": str(both)}).stdout
        self.assertRegex(shown, "^EGL Mesa Project, GL .*, 0 255 0\n$")

    def test_run(self):
        self.assertEqual(run(self.runner, self.program).stdout, DRAWN)
        self.assertEqual(run(self.runner, "--glvnd", self.program).stdout, DRAWN)
        self.assertEqual(run(self.runner, "--drop-in", "--", self.program).stdout, DRAWN)
        link = self.folder / "link"
        link.symlink_to(self.runner)
        self.assertEqual(run(link, self.program).stdout, DRAWN)

    def test_run_passes_on(self):
        run(self.runner, "sh", "-c", "exit 7", status=7)
        run(self.runner, "--glvnd", "sh", "-c", "kill -TERM $$", status=-signal.SIGTERM)
        self.assertEqual(run(self.runner, "printf", "%s|", "a b", "", "--glvnd").stdout, "a b||--glvnd|")
        self.assertEqual(run(self.runner, "cat", input="in").stdout, "in")
        shown = run(self.runner, "sh", "-c", "echo $LD_LIBRARY_PATH", env={"LD_LIBRARY_PATH": "/other"}).stdout
        self.assertEqual(shown, f"{self.libraries}:/other\n")

    def test_run_complains(self):
        self.assertIn("--glvnd", run(self.runner, "--help").stdout)
        self.assertIn("no option '--gl'", run(self.runner, "--gl", "true", status=125).stderr)
        self.assertIn("what is to be run?", run(self.runner, "--glvnd", status=125).stderr)
        self.assertIn("no program 'no-such-program'", run(self.runner, "no-such-program", status=127).stderr)
        self.assertIn("cannot be run", run(self.runner, self.folder, status=126).stderr)
        self.assertIn("cannot be run", run(self.runner, PROGRAM, status=126).stderr)

    def test_info(self):
        info = self.prefix / "bin/anteroom-info"
        shown = run(info, "--brief").stdout
        self.assertIn(str(self.libraries / "libEGL.so.1"), shown)
        self.assertIn(str(self.libraries / "libanteroom.so.0"), shown)
        self.assertIn(": chosen", shown)

    def test_documents(self):
        for tool in (self.prefix / "bin").iterdir():
            for file in ("man/man1/{}.1.gz", "bash-completion/completions/{}", "zsh/site-functions/_{}"):
                self.assertTrue((self.prefix / "share" / file.format(tool.name)).is_file(), tool.name)


@unittest.skipUnless(shutil.which("dpkg-deb") and shutil.which("dpkg-shlibdeps"), "dpkg-dev is not installed")
class Packages(Folder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run(pathlib.Path(CMAKE).with_name("cpack"), "--config", BUILD / "CPackConfig.cmake", "-B", cls.folder / "packages")
        cls.packages = [
            next((cls.folder / "packages").glob(f"{name}_*.deb")) for name in ("anteroom", "anteroom-dev")
        ]

    def control(self, package):
        fields = run("dpkg-deb", "-f", package).stdout
        return dict(re.findall(r"^(\S+): (.*(?:\n .*)*)", fields, re.MULTILINE))

    def test_control(self):
        runtime, development = (self.control(package) for package in self.packages)
        self.assertRegex(runtime["Depends"], r"\blibc6 \(>= ")
        self.assertRegex(runtime["Depends"], r"\blibvulkan1\b")
        self.assertNotRegex(runtime["Depends"], "openimageio|glfw|gtest|libegl1|libgles1")
        self.assertEqual(runtime["Section"], "libs")
        for field in ("Conflicts", "Replaces", "Provides", "Breaks"):
            self.assertNotIn(field, runtime)
        self.assertIn(f"anteroom (= {runtime['Version']})", development["Depends"])

    def test_contents(self):
        """No library of ours where the system's lie, and nothing of the development package in the other."""
        listing = run("dpkg-deb", "-c", self.packages[0]).stdout
        libraries = re.findall(r" \./(\S+\.so\S*)", listing)
        self.assertEqual(len(libraries), 4, libraries)
        for library in libraries:
            self.assertIn("/anteroom/", library)
        self.assertIn("./usr/share/glvnd/egl_vendor.d/90_anteroom.json", listing)
        self.assertNotRegex(listing, r"\.h\n|pkgconfig|cmake")

    def test_unpacked(self):
        run("dpkg-deb", "-x", self.packages[0], self.folder / "unpacked")
        shown = run(self.folder / "unpacked/usr/bin/anteroom-info").stdout
        self.assertIn(str(self.folder / "unpacked/usr/lib"), shown)

    def test_installs_and_uninstalls(self):
        root = self.folder / "root"
        (root / "var/lib/dpkg/info").mkdir(parents=True)
        (root / "var/lib/dpkg/updates").mkdir()
        (root / "var/lib/dpkg/status").touch()
        before = {path for path in root.rglob("*") if "/var/" not in str(path)}
        dpkg = ["dpkg", f"--root={root}", "--force-not-root", "--force-depends", "--force-script-chrootless", f"--log={root}/log"]
        run(*dpkg, "-i", *self.packages)
        self.assertIn(": chosen", run(root / "usr/bin/anteroom-info", "--brief").stdout)
        run(*dpkg, "-P", "anteroom-dev", "anteroom")
        after = {path for path in root.rglob("*") if "/var/" not in str(path)} - {root / "log"}
        self.assertEqual(after, before)

    @unittest.skipUnless(shutil.which("lintian"), "lintian is not installed")
    def test_lintian(self):
        run("lintian", "--allow-root", "--fail-on", "error", *self.packages)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[6:], verbosity=2)
