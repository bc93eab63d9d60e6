#!/usr/bin/env python3
"""wheel_tag.py FILE...: prints the oldest glibc with which these programs and libraries run, found by their
symbols, as a wheel's tag (manylinux_2_31_x86_64). Fails if one needs a library that is neither glibc's nor
beside it, searches libraries in folders outside its own tree, or contains the name of a file of this
checkout."""

import os
import re
import subprocess
import sys
from pathlib import Path

GLIBC = {"libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1",
         "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
MACHINES = {"X86-64": "x86_64", "AArch64": "aarch64"}


def problems(dynamic, bundled):
    """Entries of `readelf -d` that would fail on another machine."""
    needed = re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic)
    found = [f"needs {name}" for name in needed if name not in GLIBC and name not in bundled]
    for path in re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", dynamic):
        found += [f"looks for libraries in \"{folder}\"" for folder in path.split(":")
                  if not folder.startswith("$ORIGIN")]
    return found


def files_named(data, folder):
    """Paths of the folder in a program's bytes, which would differ from checkout to checkout."""
    start = rb"(?<![\w./-])" + re.escape(os.fsencode(folder)) + rb"/[\x21-\x7e]*"
    return [f"names {os.fsdecode(found)}" for found in re.findall(start, data)]


def newest_glibc(versions):
    """(major, minor) of the newest symbol version in the output of `readelf -V`."""
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
