"""The C++ sources of the plugins: the files of a source distribution, and their compilation."""

import os
import shlex
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
# A source distribution has the C++ sources in the folder "source"; a checkout has them three folders up.
CARRIED = HERE / "source"
CHECKOUT = Path("/", *HERE.parts[:-3])
FOLDERS = ("intrinsic", "heat", "core", "plugins/interface", "plugins/loader", "plugins/methods",
           "plugins/editing")
FILES = ("CMakeLists.txt", "plugins/CMakeLists.txt", "LICENSE", "CHANGELOG.md")
SUFFIXES = {".cpp", ".hpp", ".h", ".cmake", ".in", ".map", ".txt"}
# A wheel needs no driver, no pictures, and no installed libraries and headers.
OPTIONS = ("-DCMAKE_BUILD_TYPE=Release", "-DTALWEG_BUILD_DRIVER=OFF", "-DTALWEG_BUILD_DEMO=OFF",
           "-DTALWEG_BUILD_TESTS=OFF", "-DTALWEG_INSTALL=OFF", "-DCMAKE_INSTALL_LIBDIR=lib")


def root():
    """The folder with the top CMakeLists.txt; None if there are no sources, so that only plugins that were
    built elsewhere can be packed."""
    for folder in (CARRIED, CHECKOUT):
        if (folder / "core/CMakeLists.txt").is_file():
            return folder
    return None


def needed(source):
    """The files that CMake needs, relative to ``source``."""
    found = [Path(name) for name in FILES]
    for folder in FOLDERS:
        found += sorted(path.relative_to(source) for path in (source / folder).rglob("*")
                        if path.is_file() and path.suffix in SUFFIXES)
    return found


def compile_plugins(build):
    """Compiles the plugins in the folder ``build`` and returns the folder with the modules. The environment
    variable CMAKE_ARGS may add options."""
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
