"""same_curve.py FOLDER HOSTS [PROGRAM...]: every program writes one mesh in its formats, and the same
drawing is smoothed on each by the hosts, separated by commas: driver, python, page. The curves must
be those of the mesh itself, to 1e-6 of its size, or what six digits hold. Ends with 77 where nothing
could be compared."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

import makers
import shape


def y_up(points):
    return points[:, [0, 2, 1]] * (1, 1, -1)


def z_up(points):
    return points[:, [0, 2, 1]] * (1, -1, 1)


def distance(curve, other):
    """The largest distance of a point of one polyline from the other one, both ways. A polyline is a pair
    (points, closed)."""
    return max(_farthest(curve, other), _farthest(other, curve))


def _farthest(curve, other):
    points, (begins, closed) = np.asarray(curve[0]), other
    begins = np.asarray(begins)
    ends = np.roll(begins, -1, axis=0)
    if not closed:
        begins, ends = begins[:-1], ends[:-1]
    along = ends - begins
    square = np.maximum(np.einsum("ij,ij->i", along, along), 1e-300)
    away = points[:, None] - begins[None]
    t = np.clip(np.einsum("ijk,jk->ij", away, along) / square, 0, 1)
    return np.linalg.norm(away - t[..., None] * along[None], axis=2).min(axis=1).max()


def driver(*words):
    """Runs the driver. :raises AssertionError: with the driver's message, if the driver fails."""
    done = subprocess.run([os.environ["TALWEG_DRIVER"], "--quiet", *map(str, words)], check=False,
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stderr.strip())


def curves_of(path):
    """The curves of a JSON file of Talweg, as pairs (points, closed)."""
    return [(np.array([point["xyz"] for point in curve["points"]]), curve["closed"])
            for curve in json.loads(Path(path).read_text(encoding="utf-8"))["curves"]]


class Comparison:
    """Compares the curves of each host with the curves on the mesh itself."""

    def __init__(self, folder):
        self.folder = folder
        self.mesh = shape.mesh()
        makers.write_off(folder / "mesh.off", *self.mesh)
        shape.write_drawing(folder / "drawn.obj", shape.drawing())
        shape.write_drawing(folder / "drawn-y-up.obj", [(y_up(p), c) for p, c in shape.drawing()])
        self.expected = self.in_driver(makers.File("mesh.off"))
        self.failed = []

    def drawing(self, file):
        return self.folder / ("drawn-y-up.obj" if file.y_up else "drawn.obj")

    def in_driver(self, file):
        result = self.folder / "result.json"
        driver("smooth", self.folder / file.name, "--curve", self.drawing(file), "-o", result,
               *(["--repair=weld"] if file.weld else []))
        return curves_of(result)

    def in_python(self, file):
        import talweg
        mesh = talweg.read_mesh(self.folder / file.name, repair="weld" if file.weld else None)
        result = mesh.smooth(talweg.read_curves(self.drawing(file), mesh=mesh))
        return [(curve.positions, curve.closed) for curve in result.curves]

    def in_page(self, files):
        """The curves, or the error, of each file, by its name."""
        answers = {}
        for up in (False, True):
            some = [file for file in files if file.y_up == up]
            done = subprocess.run(
                ["node", Path(__file__).parent / "smooth_in_page.mjs", self.folder, self.drawing(some[0])],
                input="".join(f"{file.name}{' repair' if file.weld else ''}\n" for file in some),
                check=True, capture_output=True, text=True) if some else None
            answers.update(json.loads(done.stdout) if done else {})
        return {name: answer if isinstance(answer, str) else
                [(np.array(curve["points"]), curve["closed"]) for curve in answer]
                for name, answer in answers.items()}

    def compare(self, host, file, curves):
        """Reports curves that differ from the curve on the mesh itself."""
        if isinstance(curves, str):
            return self.fail(file, host, curves)
        if [c for _, c in curves] != [c for _, c in self.expected]:
            return self.fail(file, host, f"{len(curves)} curves, closed: {[c for _, c in curves]}")
        apart = max(distance((z_up(np.asarray(p)) if file.y_up else np.asarray(p), c), other)
                    for (p, c), other in zip(curves, self.expected)) / shape.SIZE
        print(f"{file.name:40} {host:7} {apart:.1e}")
        if not apart <= file.bound:
            return self.fail(file, host, f"{apart:.2e} of the size apart, {file.bound:.0e} are allowed")
        return None

    def compare_all(self, files, hosts):
        in_page = self.in_page(files) if "page" in hosts else {}
        own = {"driver": self.in_driver, "python": self.in_python}
        for file in files:
            for host in hosts:
                if host in own:
                    self.compare(host, file, answer_of(own[host], file))
                elif not file.beside:
                    self.compare(host, file, in_page[file.name])

    def fail(self, file, host, why):
        print(f"FAILED {file.name} {host}: {why}")
        self.failed.append(file.name)


def answer_of(host, file):
    """The curves of a host for a file, or its error."""
    try:
        return host(file)
    except Exception as error:  # pylint: disable=broad-except
        return str(error)


def made(folder, mesh, programs):
    """The files of these programs, or of all programs. Programs that are not installed are left out."""
    files = []
    for maker in makers.MAKERS:
        if programs and maker.__name__ not in programs:
            continue
        try:
            files += maker(folder, mesh)
        except makers.Missing as missing:
            print(f"skipped: {missing}")
    return files


def main():
    folder, hosts = Path(sys.argv[1]).resolve(), sys.argv[2].split(",")
    page = Path(os.environ.get("TALWEG_PAGE", ""), "talweg.js")
    if "page" in hosts and (shutil.which("node") is None or not page.is_file()):
        print("skipped: the page is not built (./run page)")
        sys.exit(77)
    folder.mkdir(parents=True, exist_ok=True)
    comparison = Comparison(folder)
    files = made(folder, comparison.mesh, sys.argv[3:])
    if not files:
        sys.exit(77)
    comparison.compare_all(files, hosts)
    print(f"{len(files)} files, {len(comparison.failed)} failures")
    sys.exit(1 if comparison.failed else 0)


if __name__ == "__main__":
    main()
