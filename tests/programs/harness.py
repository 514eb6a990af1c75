"""What the tests of real programs share: where things are, how programs run on an implementation, pictures."""

import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent
SECONDS = 1200


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


class Harness:
    """One test's view of a build folder. Pictures go to a folder of the test's own, and stay there."""

    def __init__(self, build, name):
        self.build = pathlib.Path(build).resolve()
        self.binaries = self.build / "bin"
        self.platform = "wayland" if "WAYLAND_DISPLAY" in os.environ else "x11"
        self.out = self.build / "tests" / "programs" / "out" / f"{name}-{self.platform}"
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir(parents=True)
        self.preferred = []  # folders of libraries that go before all others

    def environment(self, implementation):
        """For programs: mesa (its own ES 1.1), zink, reference (our float64 renderer), else our libraries."""
        variables = {
            name: value
            for name, value in os.environ.items()
            if name not in ("EGL_PLATFORM", "LD_PRELOAD", "GALLIUM_DRIVER", "LIBGL_ALWAYS_SOFTWARE")
        }
        system_wide = implementation in ("mesa", "zink")
        system = pathlib.Path(os.environ.get("ANTEROOM_SYSTEM_LIBRARIES", "/usr/lib/x86_64-linux-gnu"))
        libraries = system if system_wide else self.build / "lib"
        variables["LD_LIBRARY_PATH"] = ":".join(str(folder) for folder in [*self.preferred, libraries])
        if implementation == "reference":
            variables["ANTEROOM_RENDERER"] = "reference"
        if system_wide:
            variables["LIBGL_ALWAYS_SOFTWARE"] = "1"
            variables["GALLIUM_DRIVER"] = "zink" if implementation == "zink" else "llvmpipe"
        variables["SDL_VIDEODRIVER"] = self.platform
        variables["SDL_AUDIODRIVER"] = "dummy"
        variables["WAFFLE_PLATFORM"] = {"x11": "x11_egl"}.get(self.platform, self.platform)  # of eglretrace
        return variables

    def run(self, implementation, *command, watched=None, statuses=(0,), folder=None):
        """Standard output; the test fails where the program does. watched: what watch.cpp is told."""
        variables = self.environment(implementation)
        variables.update({name: str(value) for name, value in (watched or {}).items()})
        if watched:
            variables["LD_PRELOAD"] = str(self.build / "lib" / "libprograms_watch.so")
            variables["WATCH_SCREEN"] = str(self.binaries / "programs_on_screen")
        command = [str(part) for part in command]
        done = subprocess.run(
            command, env=variables, cwd=folder, capture_output=True, text=True, timeout=SECONDS, check=False
        )
        if done.returncode not in statuses:
            sys.exit(f"on {implementation}: {command}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
        return done.stdout

    def folder(self, name):
        folder = self.out / name
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def same(self, ours, theirs, by=0, fraction=0.0, mean=None):
        """Two pictures; see programs_difference."""
        command = [self.binaries / "programs_difference", ours, theirs, "--by", str(by), "--fraction", str(fraction)]
        command += [] if mean is None else ["--mean", str(mean)]
        command += ["--map", self.out / f"difference-{pathlib.Path(theirs).stem}.png"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        print((done.stdout + done.stderr).replace(f"{self.out}/", ""), end="", flush=True)
        return done.returncode == 0

    def expect_same(self, ours, theirs, **bounds):
        if not self.same(ours, theirs, **bounds):
            sys.exit(1)
