#!/usr/bin/env python3
"""What we add to a process that draws with Vulkan: memory.py BARE OURS [window]

BARE and OURS print what is resident, in KiB. The same is counted with an empty shader cache, when everything is compiled,
and with a full one. The images of a pbuffer count as ours.
"""

import os
import subprocess
import sys
import tempfile

MOST = 40 << 10
BARE, OURS, *SURFACE = sys.argv[1:]


def resident(*command, **variables):
    result = subprocess.run(command, env=os.environ | variables, capture_output=True, text=True, check=True, timeout=1200)
    sizes = {name: int(size) for size, name in (line.split() for line in result.stdout.splitlines())}
    return sizes["sum"], sum(size for name, size in sizes.items() if name.startswith(("libanteroom", "libEGL.", "libxcb")))


def main():
    bare, _ = resident(BARE)
    worst = 0
    with tempfile.TemporaryDirectory() as cache:
        for name, switch in (("without a cache", "off"), ("to an empty cache", "on"), ("from the cache", "on")):
            everything, files = resident(OURS, *SURFACE, ANTEROOM_CACHE=switch, ANTEROOM_CACHE_DIR=cache)
            worst = max(worst, everything - bare)
            print(f"{name}: {(everything - bare) / 1024:.1f} MiB more than {bare / 1024:.1f}, {files / 1024:.1f} of it our files")
    return 1 if worst > MOST else 0


if __name__ == "__main__":
    sys.exit(main())
