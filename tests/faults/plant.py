#!/usr/bin/env python3
"""plant.py --check: fails if the lines of a fault do not occur exactly once in its source.

plant.py FOLDER [WORD...]: plants the faults of faults.txt, one at a time, in a copy of this project's
sources in FOLDER, and fails if all tests that should find a fault pass. WORDs choose faults by their
sources and titles. Compiles the libraries and their tests once, then the parts that each fault changes."""

import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
SECONDS = 300  # a test that takes longer has found its fault, too
SETTINGS = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
            "-DTALWEG_BUILD_PLUGINS=OFF", "-DTALWEG_BUILD_DRIVER=OFF", "-DTALWEG_BUILD_DEMO=OFF"]


@dataclass
class Fault:
    source: str
    title: str
    old: list = field(default_factory=list)
    new: list = field(default_factory=list)
    test: list = field(default_factory=list)

    def planted_in(self, text):
        """The text with the fault. Indentation does not count where the old lines are looked for."""
        blanks = r"[ \t]*\n[ \t]*"
        pattern = r"[ \t]*" + blanks.join(re.escape(line) for line in self.old) + r"[ \t]*\n"
        new = "\n".join(self.new) + "\n"
        planted, count = re.subn(pattern, lambda _: new, text)
        if count != 1:
            raise ValueError(f"its lines are {count} times in {self.source}, not once")
        return planted


def read_faults(file):
    faults, source = [], ""
    for line in file.read_text().splitlines():
        mark, text = line[:1], line[2:].strip()
        if line.startswith("== "):
            source = line[3:].strip()
        elif mark == "#":
            faults.append(Fault(source, text))
        elif mark == "-" and source:
            faults[-1].old.append(text)
        elif mark == "+" and source:
            faults[-1].new.append(text)
        elif mark == ">" and source:
            faults[-1].test = text.split()
    for fault in faults:
        if not (fault.old and fault.new and len(fault.test) in (2, 3)):
            sys.exit(f"{file}: '{fault.title}' needs lines with -, + and >.")
    return faults


def copied(tree):
    """Copies the files that git tracks or would add. Unchanged files in the tree keep their times."""
    names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                           cwd=PROJECT, check=True, capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, names):
        source, copy = PROJECT / name, tree / name
        if source.is_file() and not (copy.is_file() and copy.read_bytes() == source.read_bytes()):
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, copy)
            shutil.copymode(source, copy)


def built(build, programs):
    done = subprocess.run(["cmake", "--build", build, "--target", *programs], capture_output=True,
                          text=True)
    return "" if done.returncode == 0 else done.stdout[-2000:]


def blas_folder(kind):
    found = list(Path("/usr/lib").glob(f"*/openblas-{kind}"))
    if not found:
        sys.exit(f"There is no libopenblas0-{kind}.")
    return str(found[0])


def passes(build, test):
    """Whether the test passes. If no test is run, it fails."""
    environment = dict(os.environ)
    if len(test) == 3:
        environment["LD_LIBRARY_PATH"] = blas_folder(test[2])
    try:
        done = subprocess.run([build / "bin" / test[0], f"--gtest_filter={test[1]}", "--gtest_brief=1"],
                              env=environment, capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return False
    if re.search(r"^\[==========\] 0 tests", done.stdout, re.M):
        sys.exit(f"{test[0]} has no test {test[1]}.")
    return done.returncode == 0


def outcome(fault, tree, build):
    source = tree / fault.source
    text = source.read_text()
    try:
        source.write_text(fault.planted_in(text))
    except ValueError as wrong:
        return f"DOES NOT APPLY: {wrong}"
    try:
        wrong = built(build, [fault.test[0]])
        if wrong:
            return f"DOES NOT COMPILE: {wrong}"
        return "NOT FOUND" if passes(build, fault.test) else "found"
    finally:
        source.write_text(text)


def check():
    faults = read_faults(Path(__file__).with_name("faults.txt"))
    wrong = []
    for fault in faults:
        try:
            fault.planted_in((PROJECT / fault.source).read_text())
        except (OSError, ValueError) as why:
            wrong.append(f"{fault.title}: {why}")
    print("\n".join([*wrong, f"{len(faults)} faults, {len(wrong)} do not apply"]))
    sys.exit(bool(wrong))


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if sys.argv[1] == "--check":
        check()
        return
    tree = Path(sys.argv[1]).resolve() / "tree"
    build = tree / "build"
    faults = [f for f in read_faults(Path(__file__).with_name("faults.txt"))
              if all(word in f"{f.source} {f.title}" for word in sys.argv[2:])]
    copied(tree)
    subprocess.run(["cmake", "-S", tree, "-B", build, *SETTINGS], check=True,
                   stdout=subprocess.DEVNULL)
    wrong = built(build, sorted({f.test[0] for f in faults}))
    if wrong:
        sys.exit(wrong)
    for test in sorted({tuple(f.test) for f in faults}):
        if not passes(build, test):
            sys.exit(f"Without a fault {' '.join(test)} fails.")
    missed = 0
    for fault in faults:
        begin = time.monotonic()
        what = outcome(fault, tree, build)
        missed += what != "found"
        print(f"{what:<9} {time.monotonic() - begin:5.0f} s  {fault.source}: {fault.title}", flush=True)
    print(f"{len(faults)} faults, {missed} not found")
    sys.exit(missed > 0)


main()
