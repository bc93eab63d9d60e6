#!/usr/bin/env python3
"""wheel_tag.py FILE...: the oldest glibc on which these programs and libraries run, by their symbols,
as a wheel's tag (manylinux_2_31_x86_64). Fails where one needs a library that is neither glibc's nor
beside it, looks for libraries elsewhere than near itself, or names a file of this checkout."""

import os
import re
import subprocess
import sys
from pathlib import Path

GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1",
         "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
MACHINES = {"X86-64": "x86_64", "AArch64": "aarch64"}


def problems(dynamic, bundled):
    """What `readelf -d` tells that no other machine may have."""
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic)
    found = [f"needs {name}" for name in needed if name not in GLIBC and name not in bundled]
    for path in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", dynamic):
        found += [f"looks for libraries in \"{folder}\"" for folder in path.split(":")
                  if not folder.startswith("$ORIGIN")]
    return found


def files_named(data, folder):
    """Paths in the folder that stand in a program: they differ from checkout to checkout."""
    start = rb"(?<![\w./-])" + re.escape(os.fsencode(folder)) + rb"/[\x21-\x7e]*"
    return [f"names {os.fsdecode(found)}" for found in re.findall(start, data)]


def newest_glibc(versions):
    """(major, minor) of the newest symbol's version in what `readelf -V` tells."""
    found = re.findall(r"\bGLIBC_(\d+)\.(\d+)", versions)
    return max(((int(a), int(b)) for a, b in found), default=(2, 5))


def readelf(option, path):
    return subprocess.run(["readelf", "-W", option, path], check=True, capture_output=True, text=True,
                          env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}).stdout


def tag(paths):
    bundled = {path.name for path in paths}
    wrong = [f"{path} {what}" for path in paths for what in problems(readelf("-d", path), bundled) +
             files_named(path.read_bytes(), Path(__file__).resolve().parents[2])]
    if wrong:
        sys.exit("\n".join(wrong))
    major, minor = max(newest_glibc(readelf("-V", path)) for path in paths)
    machine = re.search(r"Machine:.*?(X86-64|AArch64)", readelf("-h", paths[0])).group(1)
    return f"manylinux_{major}_{minor}_{MACHINES[machine]}"


if __name__ == "__main__":
    print(tag([Path(name) for name in sys.argv[1:]]))
