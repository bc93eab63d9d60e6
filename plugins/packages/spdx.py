#!/usr/bin/env python3
"""spdx.py VERSION SECONDS ROOT FILE...: prints the parts inside the packages FILE... and their licences, as
SPDX 2.3 in JSON. The document's date is SECONDS since 1970. ROOT is the sysroot of portable/sysroot.sh, for
the versions of the parts for any Linux."""

import hashlib
import json
import re
import subprocess
import sys
import time
import urllib.parse
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
BROWSER = PROJECT / "plugins/hosts/browser"

# Parts that are compiled into released files, by the package that they come from: (name, licence).
HOST = {"g++-12": ("libstdc++ and libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1"),
        "libopenmesh-dev": ("OpenMesh", "BSD-3-Clause"),
        "libeigen3-dev": ("Eigen", "MPL-2.0"),
        "libfmt-dev": ("fmt", "MIT"),
        "libpugixml-dev": ("pugixml", "MIT"),
        "nlohmann-json3-dev": ("nlohmann-json", "MIT"),
        "libcli11-dev": ("CLI11", "BSD-3-Clause"),
        "libxxhash-dev": ("xxHash", "BSD-2-Clause"),
        "libfast-float-dev": ("fast_float", "Apache-2.0 OR MIT"),
        "gcc-mingw-w64-x86-64-posix-runtime":
            ("libstdc++, libgcc and winpthreads", "GPL-3.0-or-later WITH GCC-exception-3.1 AND MIT AND BSD-3-Clause"),
        "mingw-w64-x86-64-dev": ("mingw-w64's C runtime", "ZPL-2.1"),
        "emscripten": ("libc++, compiler-rt, musl and dlmalloc of Emscripten",
                       "MIT AND Apache-2.0 WITH LLVM-exception AND CC0-1.0"),
        # The Debian packages use this library, and do not contain it.
        "libcholmod3": ("CHOLMOD with its supernodal module", "GPL-2.0-or-later")}
ROOT = {"libgcc-10-dev": ("unwinder of libgcc", "GPL-3.0-or-later WITH GCC-exception-3.1"),
        "zlib1g-dev": ("zlib", "Zlib"),
        "libpng-dev": ("libpng", "libpng-2.0")}
SOURCES = {"suitesparse": ("CHOLMOD (Core, Check, Cholesky), AMD, COLAMD of SuiteSparse",
                           "LGPL-2.1-or-later AND BSD-3-Clause"),
           "pugixml": ("pugixml", "MIT"),
           "libpng1.6": ("libpng", "libpng-2.0"),
           "zlib": ("zlib", "Zlib")}
NPM = {"meshoptimizer": ("meshoptimizer", "MIT"), "three": ("three.js", "MIT"),
       "three-mesh-bvh": ("three-mesh-bvh", "MIT")}

HEADERS = ["libopenmesh-dev", "libeigen3-dev", "nlohmann-json3-dev"]
PLUGINS = ["g++-12", *HEADERS, "libfmt-dev", "libpugixml-dev", "libgcc-10-dev", "zlib1g-dev", "suitesparse"]
PROGRAM = ["libcli11-dev", "libxxhash-dev"]
WINDOWS = ["gcc-mingw-w64-x86-64-posix-runtime", "mingw-w64-x86-64-dev", *HEADERS, "libfmt-dev", "pugixml",
           "zlib", "suitesparse"]
ENGINE = [*HEADERS, "libfmt-dev", "libfast-float-dev", "emscripten", "pugixml", "zlib"]
PAGE = [*ENGINE, *NPM]


def inside(name):
    """The parts in the file of this name."""
    if name.startswith("talweg-page-"):
        return PAGE
    if name.startswith("talweg-npm-"):
        return ENGINE
    if name.endswith("_amd64.deb"):
        return HEADERS + (PROGRAM if name.startswith("talweg_") else [])
    if "-windows-" in name:
        return [*WINDOWS, *PROGRAM, "libpng1.6"]
    if name.endswith(("-windows.zip", "-win_amd64.whl")):
        return WINDOWS
    if "-linux-" in name:
        return [*PLUGINS, *PROGRAM, "libpng-dev"]
    if name.endswith(".whl") or "blender" in name or "paraview" in name:
        return PLUGINS
    return []  # sources and Python packages contain no others' parts


def debian_version(package):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package],
                          check=False, capture_output=True, text=True)
    return done.stdout or sys.exit(f"spdx.py: {package} is not installed, so its version is not known")


def unpacked_version(package, root):
    versions = dict(line.split() for line in (Path(root) / "versions").read_text().splitlines())
    return versions.get(package) or sys.exit(f"spdx.py: {root}/versions has no version of {package}")


def source_version(name):
    """The version of a part that is compiled from Debian's sources, read from the scripts."""
    files = {"suitesparse": PROJECT / "plugins/packages/release.sh",
             "libpng1.6": PROJECT / "plugins/packages/windows/libraries/CMakeLists.txt",
             "zlib": BROWSER / "cmake/FindZLIB.cmake", "pugixml": BROWSER / "cmake/Findpugixml.cmake"}
    return re.search(rf"{name}[_-]([0-9.]*[0-9])", files[name].read_text())[1]


def npm_version(name):
    lock = json.loads((BROWSER / "package-lock.json").read_text())
    return lock["packages"][f"node_modules/{name}"]["version"]


def described(key, root):
    """(name, version, licence, package URL without the version) of a part."""
    if key in NPM:
        return (NPM[key][0], npm_version(key), NPM[key][1], f"npm/{key}")
    if key in SOURCES:
        return (SOURCES[key][0], source_version(key), SOURCES[key][1], None)
    if key in ROOT:
        return (ROOT[key][0], unpacked_version(key, root), ROOT[key][1], f"deb/debian/{key}")
    return (HOST[key][0], debian_version(key), HOST[key][1], f"deb/debian/{key}")


def package(number, name, version, licence, url=None):
    entry = {"SPDXID": f"SPDXRef-part-{number}", "name": name, "versionInfo": version,
             "licenseDeclared": licence, "licenseConcluded": licence, "copyrightText": "NOASSERTION",
             "downloadLocation": "NOASSERTION", "filesAnalyzed": False}
    if url:
        locator = f"pkg:{urllib.parse.quote(url)}@{urllib.parse.quote(version)}"
        entry["externalRefs"] = [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                  "referenceLocator": locator}]
    return entry


def file_entry(number, path, licences):
    data = path.read_bytes()
    licences = dict.fromkeys(one for licence in licences for one in licence.split(" AND "))
    return {"SPDXID": f"SPDXRef-file-{number}", "fileName": f"./{path.name}",
            "checksums": [{"algorithm": kind, "checksumValue": hashlib.new(kind.lower(), data).hexdigest()}
                          for kind in ("SHA1", "SHA256")],  # SPDX wants the former
            "licenseConcluded": " AND ".join(f"({one})" if " OR " in one else one for one in licences),
            "copyrightText": "NOASSERTION"}


def document(version, seconds, root, files):
    of_file = {path: inside(path.name) for path in files}
    used = {path: ["libcholmod3"] for path in files if path.name.endswith("_amd64.deb")}
    keys = dict.fromkeys(key for found in (*of_file.values(), *used.values()) for key in found)
    parts = {key: package(k, *described(key, root)) for k, key in enumerate(keys, 1)}
    talweg = package(0, "talweg", version, "MIT")
    entries, relations = [], [("SPDXRef-DOCUMENT", "DESCRIBES", talweg["SPDXID"])]
    for number, (path, found) in enumerate(of_file.items()):
        licences = [part["licenseConcluded"] for part in (talweg, *(parts[key] for key in found))]
        entries.append(file_entry(number, path, licences))
        own = entries[-1]["SPDXID"]
        relations.append((own, "GENERATED_FROM", talweg["SPDXID"]))
        relations += [(own, "CONTAINS", parts[key]["SPDXID"]) for key in found]
        relations += [(own, "DYNAMIC_LINK", parts[key]["SPDXID"]) for key in used.get(path, [])]
    sums = "".join(entry["checksums"][1]["checksumValue"] for entry in entries)
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"talweg-{version}",
        "documentNamespace": f"https://example.org/spdx/talweg-{version}-"
                             f"{hashlib.sha256(sums.encode()).hexdigest()[:32]}",
        "creationInfo": {"creators": ["Tool: talweg-spdx"],
                         "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds))},
        "packages": [talweg, *parts.values()], "files": entries,
        "relationships": [{"spdxElementId": one, "relationshipType": how, "relatedSpdxElement": other}
                          for one, how, other in relations]}


if __name__ == "__main__":
    json.dump(document(sys.argv[1], int(sys.argv[2]), sys.argv[3], [Path(name) for name in sys.argv[4:]]),
              sys.stdout, indent=1)
    print()
