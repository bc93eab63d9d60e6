"""Puts the plugins into the wheel, which is therefore for one platform and any Python 3. The plugins come from
the folders of TALWEG_PLUGIN_PATH, from the build of a checkout, or from a compilation of the sources: from the first
of these that applies."""

import os
import shutil
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist

try:
    from setuptools.command.bdist_wheel import bdist_wheel  # setuptools 70 and later
except ImportError:
    from wheel.bdist_wheel import bdist_wheel

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import native_sources  # noqa: E402  # pylint: disable=wrong-import-position


MODULES = ("talweg_methods.so", "talweg_methods.dll")  # with all plugins of Talweg


def plugins(build):
    """The folder with the plugins, compiled in ``build`` if there are none."""
    named = [Path(f) for f in os.environ.get("TALWEG_PLUGIN_PATH", "").split(os.pathsep) if f]
    folders = named or [native_sources.CHECKOUT / "build/lib/talweg/plugins"]
    for folder in folders:
        if any((folder / module).is_file() for module in MODULES):
            return folder
    if named or not native_sources.root():
        raise SystemExit("talweg: no talweg_methods in " + ", ".join(map(str, folders)) +
                         "; build Talweg first (./run build), or name the folder of its plugins "
                         "in TALWEG_PLUGIN_PATH.")
    return native_sources.compile_plugins(build)


class BuildWithPlugins(build_py):
    def run(self):
        super().run()
        if getattr(self, "editable_mode", False):
            return  # a checkout uses its own build
        target = Path(self.build_lib) / "talweg" / "plugins"
        target.mkdir(parents=True, exist_ok=True)
        folder = plugins(Path(self.build_lib).resolve().parent / "plugins")
        # Plugins for any system come with a shared library (plugins/packages) and the licences of all parts.
        for pattern in (*MODULES, "libtalweg-*.so.*", "libtalweg-*.dll.*"):
            for path in folder.glob(pattern):
                shutil.copy(path, target / path.name)
        licences = folder / "licences"
        if licences.is_dir():
            shutil.copytree(licences, target / "licences", dirs_exist_ok=True)


class WithNativeSources(sdist):
    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        source = native_sources.root()
        if source is None:
            raise SystemExit("talweg: a source distribution is made in a checkout or from another one.")
        for name in native_sources.needed(source):
            target = Path(base_dir, "source", name)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source / name, target)
        for name in ("native_sources.py", "LICENSE"):
            if not Path(base_dir, name).exists():
                shutil.copy((source if name == "LICENSE" else HERE) / name, base_dir)


class ForOnePlatform(Distribution):
    def has_ext_modules(self):
        return True


class WheelForAnyPython(bdist_wheel):
    def get_tag(self):
        return "py3", "none", os.environ.get("TALWEG_WHEEL_TAG") or super().get_tag()[2]


setup(distclass=ForOnePlatform,
      cmdclass={"build_py": BuildWithPlugins, "bdist_wheel": WheelForAnyPython,
                "sdist": WithNativeSources})
