#!/usr/bin/env python3
"""same_zip.py FOLDER FILE SECONDS: packs the folder into a zip with the same bytes for the same files. All
files are dated SECONDS since 1970."""

import sys
import time
import zipfile
from pathlib import Path


def pack(folder, target, seconds):
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in sorted(p for p in folder.rglob("*") if p.is_file()):
            name = path.relative_to(folder.parent).as_posix()
            entry = zipfile.ZipInfo(name, time.gmtime(seconds)[:6])
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, path.read_bytes())


if __name__ == "__main__":
    pack(Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]))
