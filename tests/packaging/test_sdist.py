"""The source distribution for pip: its contents, and that CMake accepts it. The compilation takes minutes
and is part of tests/packaging/pip_from_source.sh."""

import os
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(PROJECT / "plugins/hosts/python"))
import native_sources  # noqa: E402
from test_packages import version  # noqa: E402

try:
    import setuptools  # noqa: F401  # pylint: disable=unused-import
    import wheel  # noqa: F401  # pylint: disable=unused-import
except ImportError:
    print("skipped: no setuptools or wheel (Debian: python3-setuptools python3-wheel)")
    sys.exit(77)


def made(folder):
    subprocess.run([PROJECT / "plugins/packages/sdist.sh", folder], check=True,
                   env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
    return Path(folder, f"talweg-{version()}.tar.gz")


class SourceDistribution(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.file = made(cls.folder.name)
        with tarfile.open(cls.file) as archive:
            cls.members = archive.getmembers()
            archive.extractall(cls.folder.name)
        cls.tree = Path(cls.folder.name, f"talweg-{version()}")

    def test_has_sources_and_nothing_that_was_built(self):
        names = [Path(member.name) for member in self.members if member.isfile()]
        self.assertEqual({name.parts[0] for name in names}, {f"talweg-{version()}"})
        inside = {Path(*name.parts[1:]).as_posix() for name in names}
        for name in ("PKG-INFO", "pyproject.toml", "setup.py", "LICENSE", "source/CMakeLists.txt",
                     "source/LICENSE", "talweg/py.typed", "source/plugins/interface/exported.map"):
            self.assertIn(name, inside)
        kinds = {name.suffix for name in names}
        self.assertLessEqual(kinds, native_sources.SUFFIXES | {"", ".py", ".toml", ".cfg", ".md", ".typed"} |
                             {".1"})
        self.assertFalse([name for name in inside if "__pycache__" in name or "/tests/" in name])
        self.assertFalse([member.name for member in self.members
                          if not (member.isfile() or member.isdir())])

    def test_leaves_out_stray_files(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name, "heat")
            (folder / "__pycache__").mkdir(parents=True)
            for file in ("a.cpp", "a.o", "liba.so", "a.cpp.orig", "__pycache__/a.pyc", ".a.cpp.swp"):
                (folder / file).write_text("")
            found = native_sources.needed(Path(name))
        self.assertEqual([p.name for p in found if p.parts[0] == "heat"], ["a.cpp"])

    def test_cmake_finds_all_that_it_names(self):
        # CMake fails to generate if a source is missing.
        done = subprocess.run(["cmake", "-S", self.tree / "source", "-B", self.tree / "build",
                               *native_sources.OPTIONS], check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])

    def test_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(made(folder).read_bytes(), self.file.read_bytes())

    def test_leaves_the_checkout_as_it_was(self):
        self.assertEqual(list((PROJECT / "plugins/hosts/python").glob("*.egg-info")), [])

    def test_a_distribution_is_made_from_a_distribution(self):
        subprocess.run([sys.executable, "-c", "from setuptools import build_meta; "
                        "build_meta.build_sdist('again')"], check=True, cwd=self.tree,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with tarfile.open(self.tree / "again" / self.file.name) as archive:
            names = {member.name for member in archive.getmembers() if member.isfile()}
        self.assertEqual(names, {member.name for member in self.members if member.isfile()})


if __name__ == "__main__":
    unittest.main()
