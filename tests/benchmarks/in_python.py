"""Times of a cut, and of a network of label borders, in Python and by the driver, for whole processes.

    PYTHONPATH=plugins/hosts/python TALWEG_PLUGIN_PATH=build/lib/talweg/plugins \\
        /usr/bin/python3 tests/benchmarks/in_python.py build/bin/talweg MESH CURVE [LABELS] [RUNS]

Each reads the mesh, works, and writes the cut mesh. LABELS: a number for each face of the mesh, or
the number of regions to make. Prints processor time (user and system) in ms, the median of RUNS (5),
and peak memory in MiB. The programs take turns, so that a busy machine affects all of them equally.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

import numpy as np
import talweg

_CUT = """
import sys, talweg
mesh = talweg.Mesh(sys.argv[1], plugin="talweg.cut")
talweg.write_mesh(sys.argv[3], mesh.cut(talweg.read_curves(sys.argv[2]), open=OPEN).mesh)
"""
_LABELS = """
import sys, numpy, talweg
mesh = talweg.Mesh(sys.argv[1], plugin="talweg.labels")
made = mesh.labels(numpy.loadtxt(sys.argv[2], dtype=numpy.int64))
talweg.write_mesh(sys.argv[3], made.mesh)
"""


def measured(words):
    """Processor time in ms and peak memory in MiB."""
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(words)} failed.")
    return 1000 * (used.ru_utime + used.ru_stime), used.ru_maxrss / 1024


def table(title, ways, runs):
    times = {name: [] for name in ways}
    for _ in range(runs):
        for name, words in ways.items():
            times[name].append(measured(words))
    print(title)
    first = median(ms for ms, _ in next(iter(times.values())))
    for name, each in times.items():
        ms = median(one[0] for one in each)
        print(f"  {name:12s} {ms:8.0f} ms, {ms / first:5.2f} times, {max(one[1] for one in each):5.0f} MiB")


def made_labels(mesh, count, path):
    """Regions around points that are far from each other: the nearest of them, in space."""
    parts = talweg.Mesh(mesh)
    centres = parts.vertices[parts.faces].astype(np.float64).mean(axis=1)
    labels = np.zeros(len(centres), np.int64)
    nearest = ((centres - centres[0]) ** 2).sum(axis=1)
    for label in range(1, count):
        away = ((centres - centres[nearest.argmax()]) ** 2).sum(axis=1)
        labels[away < nearest] = label
        nearest = np.minimum(nearest, away)
    np.savetxt(path, labels, fmt="%d")


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    driver, mesh, curve = sys.argv[1:4]
    labels = sys.argv[4] if len(sys.argv) > 4 else ""
    runs = int(sys.argv[5]) if len(sys.argv) > 5 else 5
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "out.ply")
        for flag in ([], ["--open"]):
            script = _CUT.replace("OPEN", str(bool(flag)))
            table(" ".join(["cut", *flag]), {
                "driver": [driver, "-q", "cut", mesh, "--curve", curve, "-o", out, *flag],
                "driver, run": [driver, "-q", "run", "talweg.cut", mesh, "--curve", curve,
                                "--write-mesh", out, *flag],
                "Python": [sys.executable, "-c", script, mesh, curve, out]}, runs)
        if labels.isdigit():
            made_labels(mesh, int(labels), Path(folder) / "labels.txt")
            labels = str(Path(folder) / "labels.txt")
        if labels:
            table("labels", {
                "driver": [driver, "-q", "labels", mesh, labels, "--cut", out],
                "driver, run": [driver, "-q", "run", "talweg.labels", mesh, "--triangle-labels",
                                labels, "--write-mesh", out],
                "Python": [sys.executable, "-c", _LABELS, mesh, labels, out]}, runs)


if __name__ == "__main__":
    main()
