"""Puts the built plugins into the wheel, which therefore is for one platform and any Python 3."""

import os
import shutil
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

try:
    from setuptools.command.bdist_wheel import bdist_wheel  # setuptools 70 and later
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent


def built_plugins():
    named = os.environ.get("TALWEG_PLUGIN_PATH", "").split(":")
    folders = [Path(f) for f in named if f] or [HERE.parents[2] / "build/lib/talweg/plugins"]
    found = [path for folder in folders for path in sorted(folder.glob("talweg_*.so"))]
    if not any(path.name == "talweg_smooth.so" for path in found):
        raise SystemExit("talweg: no talweg_smooth.so in " + ", ".join(map(str, folders)) +
                         "; build Talweg first (./run build), or name the folder of its plugins "
                         "in TALWEG_PLUGIN_PATH.")
    return found


class BuildWithPlugins(build_py):
    def run(self):
        super().run()
        if getattr(self, "editable_mode", False):
            return  # a checkout finds its own build
        target = Path(self.build_lib) / "talweg" / "plugins"
        target.mkdir(parents=True, exist_ok=True)
        for path in built_plugins():
            shutil.copy(path, target / path.name)
        # What plugins for any Linux bring (plugins/packages): a library, and the licences of all parts.
        for path in built_plugins()[0].parent.glob("libtalweg-*.so.*"):
            shutil.copy(path, target / path.name)
        licences = built_plugins()[0].parent / "licences"
        if licences.is_dir():
            shutil.copytree(licences, target / "licences", dirs_exist_ok=True)


class ForOnePlatform(Distribution):
    def has_ext_modules(self):
        return True


class WheelForAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", os.environ.get("TALWEG_WHEEL_TAG") or super().get_tag()[2]


setup(distclass=ForOnePlatform,
      cmdclass={"build_py": BuildWithPlugins, "bdist_wheel": WheelForAnyPython})
