"""Prints the table of times in docs/paraview.md: processor time of UpdatePipeline, medians of five new
processes. This program is not a test.

pvpython tests/hosts/paraview/times.py      (TALWEG_PARAVIEW: the path of Talweg.so; TALWEG_MESHES: the meshes)
"""

import statistics
import subprocess
import sys
import time

from support import pv, real_mesh, reference_curve
from support import told as outcome

_ROUNDS = 5
_LARGE = "mouse_skull_984k"


def told(what, filter):
    begun = time.process_time()
    filter.UpdatePipeline()
    print(f"TIME {what}: {time.process_time() - begun}", flush=True)
    if outcome(filter).startswith("No result"):
        sys.exit(outcome(filter))


def mesh_of(name):
    mesh = pv.PLYReader(FileNames=[str(real_mesh(name + ".ply"))])
    mesh.UpdatePipeline()
    return mesh


def drawing_on(name):
    return pv.TalwegSmoothVertices(Mesh=mesh_of(name), PointIds=" ".join(map(str, reference_curve(name))))


def curve(name):
    filter = drawing_on(name)
    told("the first curve", filter)
    filter.Tau = 2
    told("a new Tau", filter)


def field(name):
    filter = drawing_on(name)
    filter.UpdatePipeline()
    filter.DistanceField = 1
    told("Distance Field", filter)


def cut(name):
    mesh = pv.Elevation(Input=mesh_of(name))
    mesh.UpdatePipeline()  # a slice needs an up-to-date input
    slice = pv.Slice(Input=mesh)
    slice.SliceType.Normal = [0, 1, 0]
    slice.UpdatePipeline()
    filter = pv.TalwegCut(Mesh=mesh, Curve=slice)
    told("Cut along a slice", filter)
    filter.Merge = 1e-9
    told("Cut after a change of Merge", filter)


def medians(work, name):
    times = {}
    for _ in range(_ROUNDS):
        printed = subprocess.run(["pvpython", __file__, work.__name__, name], capture_output=True, text=True,
                                 check=True).stdout
        for line in printed.splitlines():
            if line.startswith("TIME "):
                what, seconds = line[5:].split(": ")
                times.setdefault(what, []).append(float(seconds))
    for what, of in times.items():
        print(f"{name:18} {what:28} {statistics.median(of):5.2f} s, {min(of):.2f} to {max(of):.2f}", flush=True)


if len(sys.argv) > 2:
    {"curve": curve, "field": field, "cut": cut}[sys.argv[1]](sys.argv[2])
else:
    medians(curve, _LARGE)
    medians(cut, _LARGE)
    for one in ("tooth_ct_119k", "brain_icbm_164k", _LARGE):
        medians(field, one)
