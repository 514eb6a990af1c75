#!/usr/bin/env python3
"""neverball.py neverball BUILD: Neverball, a game of Debian's archive that can be built for OpenGL ES 1.1.

Its source is fetched and built in archive.cache(), once. The title and a replay of the game's own are drawn with a
clock that goes on by the same amount every frame, and compared with Mesa's pictures in windows, and with those of the
float64 renderer without.
neverball.py speed BUILD: time and processor time a frame on Anteroom, Mesa and zink.
"""

import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import archive
from harness import Harness, skip

# Edges, and steep patterns.
ALIKE = {"by": 6, "fraction": 0.01, "mean": 0.2}
MAPS = ("data/ball", "data/geom", "data/item", "data/gui", "data/map-back")
LEVELS = ("data/map-medium/title.map", "data/map-medium/locks.map")
STEP = 20  # ms a frame
# Arguments, and the frames to compare.
SCENES = {
    "title": ([], [20, 80]),
    "replay": (["-r", "data/gui/demo1.nbr"], [50, 150]),
}
# Mesa does not clamp lit colors before the texture environment (2.12.5): light that does not add up to more than 1.
DIM = {"WATCH_LIGHT": 0.4}


def make(folder):
    """Whether it could be built in the source folder."""
    maps = [*(file for part in MAPS for file in (folder / part).rglob("*.map")), *(folder / level for level in LEVELS)]
    solids = [str(file.relative_to(folder).with_suffix(".sol")) for file in maps]
    settings = ["ENABLE_OPENGLES=1", "ENABLE_NLS=0", "CFLAGS=-O2 -w -fcommon"]  # of its time: -fcommon
    with (folder / "anteroom-build.log").open("w", encoding="utf-8") as log:
        command = ["make", f"-j{os.cpu_count()}", *settings, "neverball", "mapc", *solids]
        return subprocess.run(command, cwd=folder, stdout=log, stderr=log, check=False).returncode == 0


def unpack(place):
    """The source folder, or None where the archive has no source."""
    here = os.getcwd()
    os.chdir(place)
    try:
        # Only the authors' own archive: what Debian changes does not concern us.
        if not archive.fetch("deb-src", "source", "--download-only", "--tar-only", "neverball"):
            return None
    finally:
        os.chdir(here)
    (tarball,) = pathlib.Path(place).glob("*.orig.tar.*")
    subprocess.run(["tar", "-C", place, "-xf", tarball], check=True)
    tarball.unlink()
    (folder,) = (entry for entry in pathlib.Path(place).iterdir() if entry.is_dir())
    return folder


def game():
    """The folder with the program and its data."""
    finished = archive.cache() / "neverball"
    if not finished.is_dir():
        finished.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=finished.parent) as place:
            folder = unpack(place)
            if not folder:
                skip("neverball's source cannot be had from Debian's archive")
            if not make(folder):
                sys.exit((folder / "anteroom-build.log").read_text(encoding="utf-8")[-4000:])
            try:
                folder.rename(finished)
            except OSError:
                pass  # another process was faster
    return finished


def play(harness, folder, implementation, scene, frames, shown=(), size=(800, 600), **variables):
    out = harness.folder(f"{implementation}/{scene}")
    home = harness.folder(f"{implementation}/{scene}/home")
    settings = home / ".neverball"
    settings.mkdir(exist_ok=True)
    text = f"width {size[0]}\nheight {size[1]}\nvsync 0\njoystick 0\nsound_volume 0\nmusic_volume 0\n"
    (settings / "neverballrc").write_text(text, encoding="utf-8")
    watched = {
        "HOME": home,
        "WATCH_FOLDER": out,
        "WATCH_FRAMES": ",".join(str(frame) for frame in frames),
        "WATCH_SHOWN": ",".join(str(frame) for frame in shown),
        "WATCH_STEP": STEP,
        **variables,
    }
    command = [folder / "neverball", "-d", folder / "data", *SCENES[scene][0]]
    harness.run(implementation, *command, watched=watched, folder=folder)
    log = (settings / "neverball.log").read_text(encoding="utf-8")
    renderer = re.search(r"GL renderer: (.*)", log)
    if not renderer or ("Anteroom" in renderer[1]) != (implementation not in ("mesa", "zink")):
        sys.exit(f"not on {implementation}:\n{log}")
    return out


def compare(harness, folder, names, scene, frames, **options):
    ours, theirs = (play(harness, folder, name, scene, frames, **options) for name in names)
    for frame in frames:
        harness.expect_same(ours / f"{frame:04}.ppm", theirs / f"{frame:04}.ppm", **ALIKE)


def neverball(harness):
    folder = game()
    for scene, (_, frames) in SCENES.items():
        names = ("anteroom", "mesa")
        compare(harness, folder, names, scene, frames, shown=frames[-1:], **DIM)
        names = ("offscreen", "reference")
        compare(harness, folder, names, scene, frames[:1], size=(320, 240), SDL_VIDEODRIVER="offscreen")


def processor_seconds():
    times = os.times()
    return times.children_user + times.children_system


def speed(harness):
    """Runs of two lengths, whose difference is free of what a start costs; medians of rounds."""
    folder = game()
    first, last = 20, 220
    spans = {name: [] for name in ("anteroom", "mesa", "zink")}
    for _ in range(3):
        for implementation, rounds in spans.items():
            ends = []
            for end in (first, last):
                begin = time.monotonic(), processor_seconds()
                play(harness, folder, implementation, "replay", [end])
                ends.append((time.monotonic() - begin[0], processor_seconds() - begin[1]))
            rounds.append([long - short for short, long in zip(*ends)])
    for implementation, rounds in spans.items():
        wall, processor = zip(*rounds)
        ratios = [[own / theirs for own, theirs in zip(*pair)] for pair in zip(rounds, spans["mesa"])]
        to_mesa = [statistics.median(column) for column in zip(*ratios)]
        print(
            f"{implementation}: {(last - first) / statistics.median(wall):.1f} frames a second, "
            f"{1000 * statistics.median(processor) / (last - first):.1f} ms of the processor a frame; "
            f"to Mesa's: {to_mesa[0]:.2f} of the time, {to_mesa[1]:.2f} of the processor's"
        )


def main():
    what, build = sys.argv[1:]
    {"neverball": neverball, "speed": speed}[what](Harness(build, f"neverball-{what}"))


if __name__ == "__main__":
    main()
