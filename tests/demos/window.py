#!/usr/bin/env python3
"""Runs rooms in windows of a virtual X server: window.py frames|refusal|no_display ROOMS LIBRARIES

frames: with the EGL of LIBRARIES, frames of a window are those of the offscreen picture files.
refusal: the EGL of LIBRARIES has no windows; the program says so, and what to do.
no_display: the same without any X server.
"""

import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile

SECONDS = 120
SMALL = ["--size", "96x72", "--samples", "0"]


@contextlib.contextmanager
def x_server():
    """The display of a server that lives as long as the block; the server itself finds a free number."""
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", "640x480x24", "-nolisten", "tcp"],
        pass_fds=[writer],
        stderr=subprocess.DEVNULL,
    )
    os.close(writer)
    try:
        with os.fdopen(reader) as answer:
            number = answer.readline().strip()
        if not number:
            sys.exit("Xvfb did not start")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()


def rooms(program, libraries, display, *arguments):
    # The program chooses an offscreen platform by itself; EGL_PLATFORM would choose the window's, too.
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "EGL_PLATFORM", "WAYLAND_DISPLAY")}
    environment["LD_LIBRARY_PATH"] = libraries
    if display:
        environment["DISPLAY"] = display
    return subprocess.run(
        [program, *arguments], env=environment, capture_output=True, text=True, timeout=SECONDS, check=False
    )


def check_frames(program, libraries):
    with tempfile.TemporaryDirectory() as folder, x_server() as display:
        pictures = {}
        for name, options in {"file": [], "window": ["--window"]}.items():
            out = pathlib.Path(folder) / name
            frames = ["lighting", *SMALL, "--time", "2", "--frames", "0-3", "--out", str(out)]
            done = rooms(program, libraries, display if options else None, *frames, *options)
            if done.returncode != 0:
                sys.exit(f"{name}: exit status {done.returncode}\n{done.stderr}")
            pictures[name] = {path.name: path.read_bytes() for path in sorted(out.iterdir())}
        wanted, got = pictures["file"], pictures["window"]
        if len(wanted) != 4 or len(set(wanted.values())) != 4:
            sys.exit(f"four different pictures were expected without a window: {list(wanted)}")
        if list(got) != list(wanted):
            sys.exit(f"the window wrote {list(got)}")
        different = [name for name in wanted if got[name] != wanted[name]]
        if different:
            sys.exit(f"the window's pictures are others: {different}")


def expect_message(done, words):
    lines = done.stderr.splitlines()
    if done.returncode != 2 or len(lines) != 1 or not all(word in lines[0] for word in words):
        sys.exit(f"exit status {done.returncode}, one line with {words} was expected:\n{done.stderr}")


def main():
    what, program, libraries = sys.argv[1:]
    window = ["lighting", *SMALL, "--window"]
    if what == "frames":
        check_frames(program, libraries)
    elif what == "refusal":
        with x_server() as display:
            done = rooms(program, libraries, display, *window)
        expect_message(done, ["--window", "Anteroom", "window surfaces", "LD_LIBRARY_PATH="])
    elif what == "no_display":
        expect_message(rooms(program, libraries, None, *window), ["--window", "DISPLAY"])
    else:
        sys.exit(__doc__)


main()
