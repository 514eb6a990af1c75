#!/usr/bin/env python3
"""Real programs in windows: programs.py rooms|glfw|sdl|eglinfo|apitrace BUILD, on an X or Wayland server.

See README.md for what each holds against what.
"""

import re
import sys

import archive
from harness import Harness, skip

IMPLEMENTATIONS = ("anteroom", "mesa")
# Two implementations that both follow the specification may round otherwise anywhere, and on edges they may choose
# another pixel.
ALIKE = {"by": 2, "fraction": 0.005, "mean": 0.2}
# The same in the demos, whose lights shine brighter.
DEMO_ALIKE = {"by": 2, "fraction": 0.05, "mean": 0.3}
# A picture drawn in a window, where y points down, and the same drawn elsewhere: otherwise rounded.
SAME = {"by": 4, "fraction": 0.0005, "mean": 0.02}


def numbers(frames):
    return ",".join(str(frame) for frame in frames)


def find_glfw(harness):
    """Debian's GLFW knows either X11 or Wayland, and only one of them can be installed."""
    if harness.platform == "wayland":
        folder = archive.package("libglfw3-wayland")
        if not folder:
            skip("libglfw3-wayland cannot be had from Debian's archive")
        harness.preferred.append(folder)


def rooms(harness):
    """What is in the window, and on the screen, is what is in the files without a window."""
    find_glfw(harness)
    folder = harness.folder("lighting")
    frames = [harness.binaries / "rooms", "lighting", "--size", "320x240", "--samples", "0", "--frames", "0-2"]
    watched = {"WATCH_FOLDER": folder, "WATCH_FRAMES": "0,1,2", "WATCH_SHOWN": "0,2"}
    harness.run("anteroom", *frames, "--window", "--out", folder / "window", watched=watched)
    harness.run("anteroom", *frames, "--out", folder / "file")
    for file in sorted((folder / "file").iterdir()):
        harness.expect_same(folder / "window" / file.name, file, **SAME)
        harness.expect_same(folder / f"{file.stem[-4:]}.ppm", folder / "window" / file.name)


def compare_frames(harness, program, kept, shown):
    for implementation in IMPLEMENTATIONS:
        watched = {"WATCH_FRAMES": numbers(kept), "WATCH_SHOWN": numbers(shown)}
        watched["WATCH_FOLDER"] = harness.folder(implementation)
        print(harness.run(implementation, harness.binaries / program, watched=watched), end="")
    for frame in kept:
        ours, theirs = (harness.out / implementation / f"{frame:04}.ppm" for implementation in IMPLEMENTATIONS)
        harness.expect_same(ours, theirs, **ALIKE)


def glfw(harness):
    find_glfw(harness)
    last = [3, 7, 11, 15, 19]  # of every size
    compare_frames(harness, "programs_glfw", last, last)


def sdl(harness):
    # Where Weston puts windows is its own affair: the second one is above the first.
    shown = [1, 5, 9] if harness.platform == "wayland" else [0, 1, 4, 5, 7, 9]
    compare_frames(harness, "programs_sdl", [0, 1, 4, 5, 7, 8, 9], shown)


def eglinfo(harness):
    """It runs through, and lists ES 1.x configs with windows on the platforms that there are."""
    wanted = {"x11": "X11", "wayland": "Wayland"}[harness.platform]
    text = harness.run("anteroom", "eglinfo", statuses=(0, 1))  # 1: there is a platform without a server
    parts = dict(re.findall(r"^(\w+) platform:\n(.*?)(?=^\w+ platform:|\Z)", text, re.MULTILINE | re.DOTALL))
    print(text)
    for platform in (wanted, "Surfaceless"):
        part = parts.get(platform, "")
        if "EGL vendor string: Anteroom" not in part or not re.search(r"^EGL client APIs: OpenGL_ES\s*$", part, re.M):
            sys.exit(f"nothing of Anteroom on the platform {platform}")
        configs = re.findall(r"^0x[0-9a-f]+ .*$", part, re.MULTILINE)
        windows = [config for config in configs if re.search(r"\by\s+.*\bwin\b", config)]
        if not configs or bool(windows) != (platform == wanted):
            sys.exit(f"{platform}: {len(windows)} of {len(configs)} configs have windows")


def apitrace(harness):
    """A trace of a program on either implementation, replayed on either: always the same pictures."""
    find_glfw(harness)
    size = ["--size", "320x256", "--samples", "0"]  # no smaller than what is drawn elsewhere: eglretrace widens windows
    for traced in IMPLEMENTATIONS:
        folder = harness.folder(traced)
        trace = folder / "trace"
        command = [harness.binaries / "rooms", "reflect", "--window", *size, "--frames", "0-1", "--out", folder]
        harness.run(traced, "apitrace", "trace", "--api=egl", f"--output={trace}", *command)
        for replayed in IMPLEMENTATIONS:
            text = harness.run(replayed, "eglretrace", "-s", folder / f"{replayed}-", trace)
            # Lines of eglretrace about calls are complaints.
            if complaints := re.findall(r"^\d+: .*$", text, re.MULTILINE):
                sys.exit(f"eglretrace on {replayed}: {complaints}")
            # On Wayland, Mesa's first frame has still the size that eglretrace has made the window in.
            bounds = SAME if traced == replayed else DEMO_ALIKE
            harness.expect_same(sorted(folder.glob(f"{replayed}-*.png"))[-1], folder / "reflect-0001.png", **bounds)


def main():
    what, build = sys.argv[1:]
    tests = {test.__name__: test for test in (rooms, glfw, sdl, eglinfo, apitrace)}
    tests[what](Harness(build, what))


if __name__ == "__main__":
    main()
