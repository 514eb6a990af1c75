"""Debian's archive, asked through a private configuration of apt that is made from the machine's own."""

import os
import pathlib
import re
import subprocess
import tempfile

SETTINGS = pathlib.Path("/etc/apt")


def cache():
    """Where what comes from the archive is kept and built, outside of every source tree."""
    chosen = os.environ.get("ANTEROOM_PROGRAMS_CACHE")
    if chosen:
        return pathlib.Path(chosen)
    return pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "anteroom-programs"


def sources(kind):
    """The machine's sources as those of one kind, deb or deb-src: file names and contents."""
    files = [SETTINGS / "sources.list", *sorted((SETTINGS / "sources.list.d").glob("*"))]
    for file in (file for file in files if file.is_file()):
        text = file.read_text(encoding="utf-8")
        if file.suffix == ".sources":
            yield file.name, re.sub(r"^Types:.*$", f"Types: {kind}", text, flags=re.MULTILINE | re.IGNORECASE)
        elif file.suffix == ".list":
            lines = [line for line in text.splitlines() if re.match(r"deb\s", line)]
            yield file.name, "".join(re.sub(r"^deb\s", f"{kind} ", line) + "\n" for line in lines)


def fetch(kind, *command):
    """Runs apt-get in the current folder with fresh lists; False where the archive or the package is not there."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for part in ("parts", "lists/partial", "archives/partial"):
            (folder / part).mkdir(parents=True)
        for file, text in sources(kind):
            (folder / "parts" / file).write_text(text, encoding="utf-8")
        options = {
            "Dir::Etc::sourcelist": "/dev/null",
            "Dir::Etc::sourceparts": folder / "parts",
            "Dir::State::lists": folder / "lists",
            "Dir::Cache": folder,
            "Dir::Cache::archives": folder / "archives",
            "APT::Sandbox::User": "root",
            "Acquire::Retries": "2",
            "Acquire::http::Timeout": "20",
        }
        apt = ["apt-get", "-q", *(part for key, value in options.items() for part in ("-o", f"{key}={value}"))]
        for arguments in (["update"], list(command)):
            try:
                done = subprocess.run([*apt, *arguments], capture_output=True, text=True, timeout=300, check=False)
            except (OSError, subprocess.TimeoutExpired) as error:
                print(error)
                return False
        if done.returncode != 0:
            print(done.stdout + done.stderr)
        return done.returncode == 0


def package(name):
    """The folder with the shared libraries of a package that is not installed, or None."""
    folder = cache() / name
    if not folder.is_dir():
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent) as place:
            os.chmod(place, 0o755)
            if not _unpack(name, place):
                return None
            try:
                os.rename(place + "/unpacked", folder)
            except OSError:
                pass  # another process was faster
    found = list(folder.glob("usr/lib/*/*.so.*"))
    return found[0].parent if found else None


def _unpack(name, place):
    here = os.getcwd()
    os.chdir(place)
    try:
        if not fetch("deb", "download", name):
            return False
        files = [str(file) for file in pathlib.Path(place).glob("*.deb")]
        return subprocess.run(["dpkg-deb", "-x", files[0], place + "/unpacked"], check=False).returncode == 0
    finally:
        os.chdir(here)
