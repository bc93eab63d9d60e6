#!/usr/bin/env python3
"""spdx.py VERSION SECONDS FILE...: what is inside the packages FILE..., and its licences, as SPDX 2.3
in JSON on the standard output. SECONDS since 1970 are its date."""

import hashlib
import json
import subprocess
import sys
import time
from pathlib import Path

# What is compiled into what is given away; the versions are those of the Debian packages that it was
# built from. The last is a shared library of its own.
PARTS = [("libstdc++ and libgcc", "g++-12", "GPL-3.0-or-later WITH GCC-exception-3.1"),
         ("OpenMesh", "libopenmesh-dev", "BSD-3-Clause"),
         ("Eigen", "libeigen3-dev", "MPL-2.0"),
         ("fmt", "libfmt-dev", "MIT"),
         ("pugixml", "libpugixml-dev", "MIT"),
         ("nlohmann-json", "nlohmann-json3-dev", "MIT"),
         ("CLI11", "libcli11-dev", "BSD-3-Clause"),
         ("xxHash", "libxxhash-dev", "BSD-2-Clause")]
FIXED = [("zlib", "1.2.11", "Zlib"), ("libpng", "1.6.37", "libpng-2.0"),
         ("CHOLMOD (Core, Check, Cholesky), AMD, COLAMD of SuiteSparse", "5.12.0",
          "LGPL-2.1-or-later AND BSD-3-Clause")]
# Only in the page for browsers.
PAGE = ("libc++, compiler-rt and musl of Emscripten", "emscripten",
        "MIT AND (Apache-2.0 WITH LLVM-exception)")


def debian_version(package):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], check=False,
                          capture_output=True, text=True)
    return done.stdout or "unknown"


def package(number, name, version, licence):
    return {"SPDXID": f"SPDXRef-part-{number}", "name": name, "versionInfo": version,
            "licenseDeclared": licence, "licenseConcluded": licence, "copyrightText": "NOASSERTION",
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False}


def document(version, seconds, files):
    page = [PAGE] if any(path.name.startswith("talweg-page-") for path in files) else []
    parts = [(name, debian_version(of), licence) for name, of, licence in PARTS + page] + FIXED
    packages = [package(0, "talweg", version, "MIT")]
    packages += [package(k, *part) for k, part in enumerate(parts, 1)]
    sums = [hashlib.sha256(path.read_bytes()).hexdigest() for path in files]
    inside = hashlib.sha256("".join(sums).encode()).hexdigest()
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"talweg-{version}",
        "documentNamespace": f"https://example.org/spdx/talweg-{version}-{inside[:32]}",
        "creationInfo": {"creators": ["Tool: talweg-spdx"],
                         "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds))},
        "packages": packages,
        "files": [{"SPDXID": f"SPDXRef-file-{k}", "fileName": f"./{path.name}",
                   "checksums": [{"algorithm": "SHA256", "checksumValue": value}],
                   "licenseConcluded": "NOASSERTION", "copyrightText": "NOASSERTION"}
                  for k, (path, value) in enumerate(zip(files, sums))],
        "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                           "relatedSpdxElement": "SPDXRef-part-0"}] +
                         [{"spdxElementId": "SPDXRef-part-0", "relationshipType": "CONTAINS",
                           "relatedSpdxElement": f"SPDXRef-part-{k}"}
                          for k in range(1, len(packages))]}


if __name__ == "__main__":
    json.dump(document(sys.argv[1], int(sys.argv[2]), [Path(name) for name in sys.argv[3:]]),
              sys.stdout, indent=1)
    print()
