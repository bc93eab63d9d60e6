"""The wheel: for this kind of machine, complete, and usable without environment variables; and a checkout
without a build."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import support

PACKAGE = support.SOURCE / "plugins/hosts/python"
PLUGINS = Path(os.environ["TALWEG_PLUGIN_PATH"])

SCRIPT = """
import sys
sys.path.insert(0, sys.argv[1])
import numpy, talweg
sys.path.insert(0, sys.argv[2])
import support
print(talweg.smooth(support.hills(), support.staircase()).report.termination)
print(talweg.plugin("talweg.smooth").path)
"""


def python(*arguments, cwd, **environment):
    """Runs Python without Talweg's environment variables, except the given ones."""
    clean = {key: value for key, value in os.environ.items()
             if key not in ("PYTHONPATH", "TALWEG_PLUGIN_PATH")}
    return subprocess.run([sys.executable, *map(str, arguments)], cwd=cwd, text=True, check=False,
                          env={**clean, **environment}, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def finds(self, package, plugins):
        done = python("-c", SCRIPT, package, Path(__file__).parent, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(done.stdout.split(),
                         ["converged", str((plugins / "talweg_methods.so").resolve())])

    def build(self, plugins):
        try:
            import setuptools  # pylint: disable=import-outside-toplevel,unused-import
            import wheel  # pylint: disable=import-outside-toplevel,unused-import
        except ImportError:
            self.skipTest("no setuptools or wheel (Debian: python3-setuptools python3-wheel)")
        shutil.copytree(PACKAGE, self.folder / "source")
        return python("-c", "from setuptools import build_meta; build_meta.build_wheel('..')",
                      cwd=self.folder / "source", TALWEG_PLUGIN_PATH=str(plugins))

    def test_wheel(self):
        done = self.build(PLUGINS)
        self.assertEqual(done.returncode, 0, done.stdout)
        wheels = list(self.folder.glob("*.whl"))
        self.assertEqual(len(wheels), 1)
        self.assertRegex(wheels[0].name, r"^talweg-[0-9.]+-py3-none-linux_\w+\.whl$")
        target = self.folder / "target"
        with zipfile.ZipFile(wheels[0]) as archive:
            archive.extractall(target)  # an installer does no more for this kind of wheel
            names = archive.namelist()
        self.assertIn("talweg/py.typed", names)
        self.assertEqual([n for n in names if ".data/" in n], [])
        self.assertEqual([n for n in names if n.endswith(".so")], ["talweg/plugins/talweg_methods.so"])
        metadata = next(target.glob("*.dist-info"))
        self.assertIn("Root-Is-Purelib: false", (metadata / "WHEEL").read_text())
        self.assertIn("Requires-Dist: numpy", (metadata / "METADATA").read_text())
        self.finds(target, target / "talweg/plugins")

    def test_no_wheel_without_plugins(self):
        done = self.build(self.folder)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"no talweg_methods in {self.folder}; build Talweg first", done.stdout)
        self.assertEqual(list(self.folder.glob("*.whl")), [])

    def test_without_plugins_and_sources_the_folder_of_the_build_is_named(self):
        done = self.build("")
        self.assertNotEqual(done.returncode, 0)
        checkout = Path("/", *(self.folder / "source").resolve().parts[:-3])
        self.assertIn(f"no talweg_methods in {checkout / 'build/lib/talweg/plugins'}; build Talweg first",
                      done.stdout)

    def test_near_the_root_of_the_file_system(self):
        # The files as after pip install --target.
        shutil.copytree(PACKAGE / "talweg", self.folder / "talweg")
        shutil.copytree(PLUGINS, self.folder / "talweg/plugins")
        self.finds(self.folder, self.folder / "talweg/plugins")

    def test_checkout(self):
        checkout = self.folder / "checkout"
        shutil.copytree(PACKAGE, checkout / "plugins/hosts/python")
        (checkout / "plugins/interface").mkdir()
        shutil.copy(support.SOURCE / "plugins/interface/talweg_plugin.h",
                    checkout / "plugins/interface")
        plugins = checkout / "build/lib/talweg/plugins"
        shutil.copytree(PLUGINS, plugins)
        self.finds(checkout / "plugins/hosts/python", plugins)


if __name__ == "__main__":
    unittest.main()
