#!/usr/bin/env python3
"""usage: agree.py FOLDER MESHES DRIVER [DRIVER ...] [--quick]

Runs the same commands with every DRIVER (talweg of another compiler or build type), and with the first
DRIVER again on two threads, and compares their files with those of the first run. The second run of the
first DRIVER must give the same bytes. The others must give the same topology (curves, points, their faces
and edges, faces of cut meshes, labels, exit codes), and positions within 1e-9 of the mesh's size. Prints
for each driver how many files have the same bytes and the largest difference of positions. Leaves all
files in FOLDER.

MESHES has NAME.ply and NAME.through, arguments for `talweg draw` (talweg-scenes makes some), or NAME.ply
beside ../reference/curves/NAME*.txt. Binary little-endian PLY. --quick: fewer commands.
Exit code: 0 all agree, 1 they do not, 2 something could not be done.
"""

import argparse
import array
import hashlib
import json
import math
import pathlib
import re
import shlex
import subprocess
import sys

TOLERANCE = 1e-9  # of the mesh's size, the diagonal of its box
NOT_RESULTS = {"time_ms", "peak_memory_mib"}
LABELS_FACES = 150_000  # labels of larger meshes would only repeat what smaller ones tell


def vertices_of(mesh):
    """Positions in a binary PLY whose vertices come first and are x, y, z of float or double."""
    data = mesh.read_bytes()
    end = data.index(b"end_header\n") + len("end_header\n")
    header = data[:end].decode("ascii", "replace")
    vertices = re.search(r"element vertex (\d+)\n((?:property .*\n)*)", header)
    kinds = [line.split()[1] for line in vertices[2].splitlines()]
    if kinds not in (["float"] * 3, ["double"] * 3) or "binary_little_endian" not in header:
        raise ValueError(f"{mesh}: vertices are not three floats or doubles in binary")
    values = array.array("f" if kinds[0] == "float" else "d")
    values.frombytes(data[end : end + int(vertices[1]) * 3 * values.itemsize])
    return list(zip(values[0::3], values[1::3], values[2::3]))


def size_of(points):
    used = [p for p in points if all(map(math.isfinite, p))]
    return math.dist(*([f(p[k] for p in used) for k in range(3)] for f in (min, max)))


def run(driver, arguments, folder):
    """One command in a folder; its exit code."""
    done = subprocess.run([driver, "--quiet", *map(str, arguments)], cwd=folder, capture_output=True, text=True)
    (folder / "errors.txt").open("a").write(done.stderr)
    return done.returncode


class Subject:
    """A mesh with drawings and labels, the same files for all drivers."""

    def __init__(self, mesh, driver, folder):
        self.name, self.mesh = mesh.stem, mesh
        points = vertices_of(mesh)
        self.size = size_of(points)
        info = json.loads(subprocess.run([driver, "info", mesh, "--json"], capture_output=True, text=True).stdout)
        self.repair = [] if info["verdict"] == "usable" else ["--repair"]
        folder.mkdir(parents=True, exist_ok=True)
        self.curves, self.across, self.labels = [], None, None
        through = mesh.with_suffix(".through")
        if through.exists():
            self.draw(driver, folder, "drawn.json", shlex.split(through.read_text()))
        else:
            self.curves = sorted((mesh.parent / "../reference/curves").resolve().glob(f"{self.name}*.txt"))
        if not self.curves:  # without stored drawings: a drawing through four vertices
            count = len(points)
            ways = [count // 7, count // 3, count // 2, 5 * count // 6]
            self.draw(driver, folder, "drawn.json", ["--through", ",".join(map(str, ways)), "--points", "rough"])
        if not self.curves:
            return
        # A second one through places of the first, so that they meet and cross.
        first = json.loads(self.as_json(driver, folder).read_text())["curves"][0]["points"]
        ways = [self.nearest(points, first[len(first) * k // 5]["xyz"]) for k in (1, 3, 2, 4)]
        if len(set(ways)) == 4:
            across = folder / "across.json"
            through = ["--through", ",".join(map(str, ways)), "--points", "rough"]
            arguments = ["draw", mesh, *through, "--straight", "-o", across, *self.repair]
            self.across = across if run(driver, arguments, folder) == 0 else None
        if info["faces"] <= LABELS_FACES and not self.repair:
            seeds = [points[(2 * k + 1) * len(points) // 24] for k in range(12)]
            labels = (min(range(12), key=lambda k, p=p: math.dist(p, seeds[k])) for p in points)
            self.labels = folder / "labels.txt"
            self.labels.write_text("\n".join(map(str, labels)) + "\n")

    def draw(self, driver, folder, name, ways):
        if run(driver, ["draw", self.mesh, *ways, "-o", folder / name, *self.repair], folder) == 0:
            self.curves = [folder / name]

    def as_json(self, driver, folder):
        """The first curve in our format."""
        out = folder / "first.json"
        run(driver, ["smooth", self.mesh, "--curve", self.curves[0], "--tau", "1000", "-o", out, *self.repair], folder)
        return out

    @staticmethod
    def nearest(points, place):
        return min(range(len(points)), key=lambda v: math.dist(points[v], place))

    def commands(self, quick):
        """Arguments by name; every output file has that name."""
        for curve in self.curves[: 1 if quick else None]:
            for tau in (0, 1) if quick else (0, 0.1, 0.5, 1, 2, 10):
                yield self.smooth(f"{curve.stem}-{tau}", curve, "--tau", tau)
            yield self.smooth(f"{curve.stem}-paper", curve, "--tau", 1, "--potential", "paper")
            if not quick:
                yield self.smooth(f"{curve.stem}-paper-0.2", curve, "--tau", 0.2, "--potential", "paper", "--relax", 5)
                yield self.smooth(f"{curve.stem}-within", curve, "--max-deviation", self.size / 300)
        if self.across:
            two = ["--curve", self.across]
            yield self.smooth("two", self.curves[0], *two)
            yield self.smooth("independent", self.curves[0], *two, "--independent")
            if not quick:
                yield self.smooth("two-0", self.curves[0], *two, "--tau", 0)
        cut = ["-o", "cut.obj", "--map", "cut.json", "--open", *self.repair]
        yield "cut", ["cut", self.mesh, "--curve", self.curves[0], *(two if self.across else []), *cut]
        if self.labels:
            files = ["-o", "labels.json", "--labels-out", "labels.txt", "--cut", "labels.obj", "--report", "labels-report.json"]
            yield "labels", ["labels", self.mesh, self.labels, *files]

    def smooth(self, name, curve, *options):
        files = ["-o", f"{name}.json", "--report", f"{name}-report.json"]
        return name, ["smooth", self.mesh, "--curve", curve, *options, *files, *self.repair]


def results_of(report):
    """A report without the entries that may differ from run to run."""
    if isinstance(report, dict):
        return {key: results_of(value) for key, value in report.items() if key not in NOT_RESULTS}
    return [results_of(value) for value in report] if isinstance(report, list) else report


def content_of(file):
    """The bytes of a file that are compared."""
    if file.name.endswith("-report.json"):
        return json.dumps(results_of(json.loads(file.read_text()))).encode()
    return file.read_bytes()


def apart(first, second):
    """How far positions in two files are apart; raises ValueError where something else differs."""
    if first.suffix == ".obj":
        lines = first.read_text().splitlines(), second.read_text().splitlines()
        if len(lines[0]) != len(lines[1]):
            raise ValueError("another number of vertices or faces")
        pairs = [(a, b) for a, b in zip(*lines) if a != b]
        if any(not (a.startswith("v ") and b.startswith("v ")) for a, b in pairs):
            raise ValueError("other faces")
        return max((math.dist(*(tuple(map(float, p.split()[1:])) for p in pair)) for pair in pairs), default=0.0)
    if first.suffix == ".json":
        values = json.loads(first.read_text()), json.loads(second.read_text())
        if "curves" in values[0] and "format" in values[0]:
            return curves_apart(*(value["curves"] for value in values))
        if first.name.endswith("-report.json"):
            return report_apart(*values)
        return maps_apart(*values)
    raise ValueError("other content")


def curves_apart(first, second):
    if [(c["closed"], len(c["points"])) for c in first] != [(c["closed"], len(c["points"])) for c in second]:
        raise ValueError("another number of curves or points")
    points = [(p, q) for c, d in zip(first, second) for p, q in zip(c["points"], d["points"])]
    for p, q in points:
        if (p["face"], [b == 0 for b in p["barycentric"]]) != (q["face"], [b == 0 for b in q["barycentric"]]):
            raise ValueError(f"a point in face {p['face']} lies in face {q['face']}, or on another side of it")
    return max((math.dist(p["xyz"], q["xyz"]) for p, q in points), default=0.0)


def report_apart(first, second):
    """Raises ValueError if keys, whole numbers or words differ. Measured numbers follow from positions and are
    not compared. Returns 0."""
    if isinstance(first, dict):
        if not isinstance(second, dict) or first.keys() - NOT_RESULTS != second.keys() - NOT_RESULTS:
            raise ValueError("other keys in one report")
        for key in first.keys() - NOT_RESULTS:
            report_apart(first[key], second[key])
    elif isinstance(first, list) and isinstance(second, list) and len(first) == len(second):
        for a, b in zip(first, second):
            report_apart(a, b)
    elif not (isinstance(first, float) or isinstance(second, float)) and first != second:
        if not isinstance(first, str) or re.sub(r"[-+.e\d]+", "", first) != re.sub(r"[-+.e\d]+", "", second):
            raise ValueError(f"{first} in one report, {second} in the other")
    return 0.0


def maps_apart(first, second):
    if type(first) is not type(second) or isinstance(first, (dict, list)) and len(first) != len(second):
        raise ValueError("another map")
    if isinstance(first, dict):
        for key in first:
            maps_apart(first[key], second[key])
    elif isinstance(first, list):
        for a, b in zip(first, second):
            maps_apart(a, b)
    elif first != second and not (isinstance(first, float) and abs(first - second) <= TOLERANCE):
        raise ValueError("another map")
    return 0.0


class Tally:
    def __init__(self):
        self.files = self.same = 0
        self.worst, self.problems = 0.0, []

    def compare(self, name, first, second, size, bytes_only):
        for file in sorted(first.iterdir()):
            if file.name == "errors.txt":
                continue
            self.files += 1
            other = second / file.name
            if not other.exists():
                self.problems.append(f"{name}: no {other}")
            elif content_of(file) == content_of(other):
                self.same += 1
            elif bytes_only:
                self.problems.append(f"{name}: {file} and {other} are not the same bytes")
            else:
                self.compare_positions(name, file, other, size)

    def compare_positions(self, name, file, other, size):
        try:
            distance = apart(file, other) / size
        except (ValueError, KeyError) as error:
            self.problems.append(f"{name}: {file} and {other}: {error}")
            return
        self.worst = max(self.worst, distance)
        if distance > TOLERANCE:
            self.problems.append(f"{name}: positions in {file} and {other} are {distance:.1e} of the size apart")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("meshes", type=pathlib.Path)
    parser.add_argument("drivers", nargs="+")
    parser.add_argument("--quick", action="store_true")
    given = parser.parse_args()
    drivers = [str(pathlib.Path(driver).resolve()) for driver in given.drivers]
    runs = [(drivers[0], []), (drivers[0], ["--threads", "2"])] + [(driver, []) for driver in drivers[1:]]
    names = ["first", "first, two threads", *given.drivers[1:]]
    tallies = [Tally() for _ in runs]
    commands = 0
    meshes = sorted(given.meshes.resolve().glob("*.ply"))
    if not meshes:
        print(f"no NAME.ply in {given.meshes}", file=sys.stderr)
        return 2
    for mesh in meshes:
        inputs = (given.folder / mesh.stem / "inputs").resolve()
        subject = Subject(mesh, drivers[0], inputs)
        if not subject.curves:
            print(f"{subject.name}: nothing could be drawn on it, not even repaired: left out")
            continue
        for name, arguments in subject.commands(given.quick):
            commands += 1
            folders, codes = [], []
            for k, (driver, options) in enumerate(runs):
                folder = (given.folder / mesh.stem / str(k) / name).resolve()
                folder.mkdir(parents=True, exist_ok=True)
                for old in folder.iterdir():
                    old.unlink()
                folders.append(folder)
                jobs = ["--jobs", "2"] if options and name == "independent" else []
                codes.append(run(driver, [*options, *arguments, *jobs], folder))
            for k in range(1, len(runs)):
                if codes[k] != codes[0] or codes[k] in (1, 5):  # options that no driver has, or a broken driver
                    tallies[k].problems.append(f"{subject.name} {name}: exit codes {codes[0]} and {codes[k]}")
                tallies[k].compare(f"{subject.name} {name}", folders[0], folders[k], subject.size, bytes_only=k == 1)
            digest = hashlib.sha256(b"".join(content_of(f) for f in sorted(folders[0].iterdir()) if f.name != "errors.txt"))
            print(f"{subject.name} {name}: exit code {codes[0]}, {digest.hexdigest()[:12]}", flush=True)
    print(f"\n{commands} commands")
    for name, tally in list(zip(names, tallies))[1:]:
        print(f"{name}: {tally.same} of {tally.files} files the same bytes as of the first, "
              f"positions at most {tally.worst:.1e} of the size apart, {len(tally.problems)} disagreements")
        for problem in tally.problems:
            print(f"  {problem}")
    if not all(tally.files for tally in tallies[1:]):
        print("no file was compared", file=sys.stderr)
        return 2
    return 1 if any(tally.problems for tally in tallies) else 0


if __name__ == "__main__":
    sys.exit(main())
