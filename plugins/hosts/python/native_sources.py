"""The plugins' C++ sources: which ones a source distribution carries, and how they are compiled."""

import os
import shlex
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
# A source distribution carries them in a folder; a checkout has this one as its plugins/hosts/python.
CARRIED = HERE / "source"
CHECKOUT = Path("/", *HERE.parts[:-3])
FOLDERS = ("intrinsic", "heat", "core", "plugins/interface", "plugins/loader", "plugins/methods",
           "plugins/editing")
FILES = ("CMakeLists.txt", "plugins/CMakeLists.txt", "LICENSE", "CHANGELOG.md")
SUFFIXES = {".cpp", ".hpp", ".h", ".cmake", ".in", ".map", ".txt"}
# The driver, its pictures and what is installed beside libraries have no place in a wheel.
OPTIONS = ("-DCMAKE_BUILD_TYPE=Release", "-DTALWEG_BUILD_DRIVER=OFF", "-DTALWEG_BUILD_DEMO=OFF",
           "-DTALWEG_BUILD_TESTS=OFF", "-DTALWEG_INSTALL=OFF", "-DCMAKE_INSTALL_LIBDIR=lib")


def root():
    """Where CMakeLists.txt is, or None: then only plugins that were built elsewhere can be taken."""
    for folder in (CARRIED, CHECKOUT):
        if (folder / "core/CMakeLists.txt").is_file():
            return folder
    return None


def needed(source):
    """What CMake needs of the sources, relative to them."""
    found = [Path(name) for name in FILES]
    for folder in FOLDERS:
        found += sorted(path.relative_to(source) for path in (source / folder).rglob("*")
                        if path.is_file() and path.suffix in SUFFIXES)
    return found


def compile_plugins(build):
    """The folder with plugins that CMake compiled in BUILD; CMAKE_ARGS may add options."""
    source = root()
    if not shutil.which("cmake"):
        raise SystemExit("talweg: there is no cmake to compile the plugins with (Debian: apt install "
                         "cmake g++ libopenmesh-dev libeigen3-dev libsuitesparse-dev libfmt-dev "
                         "libpugixml-dev nlohmann-json3-dev zlib1g-dev).")
    ninja = ["-G", "Ninja"] if shutil.which("ninja") else []
    jobs = os.environ.get("TALWEG_JOBS") or str(os.cpu_count() or 1)
    for command in (["cmake", "-S", source, "-B", build, *ninja, *OPTIONS,
                     *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
                    ["cmake", "--build", build, "--parallel", jobs]):
        if subprocess.run(command, check=False).returncode != 0:
            raise SystemExit("talweg: the plugins could not be compiled; CMake says why above.")
    return Path(build) / "lib/talweg/plugins"
