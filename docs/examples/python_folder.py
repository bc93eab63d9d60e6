"""Smooths the drawing of every mesh in a folder, several at a time.

usage: python_folder.py MESHES RESULTS [JOBS]

Beside each mesh (NAME.ply, .obj, .off, .stl, .om) lies its drawing NAME.txt, vertex numbers in their
order, or NAME.json, a curve file of Talweg. RESULTS gets NAME.vtp, a picture NAME.png, and summary.csv
with a row for each mesh. What cannot be done is a row that says why; the others go on. Pictures need
matplotlib (Debian: python3-matplotlib).
"""

from __future__ import annotations

import csv
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any, Dict, List, Tuple

import talweg

FORMATS = (".ply", ".obj", ".off", ".stl", ".om")
COLUMNS = ("mesh", "faces", "length_before", "length_after", "bending_before", "bending_after",
           "deviation_to_drawn_max", "warnings", "error")


def drawing_of(mesh: Path) -> Path:
    for ending in (".txt", ".json"):
        if mesh.with_suffix(ending).is_file():
            return mesh.with_suffix(ending)
    raise FileNotFoundError(f"there is no drawing {mesh.with_suffix('.txt').name}")


def smoothed(path: Path, results: Path) -> Dict[str, Any]:
    """Does one mesh. Runs in a process of its own, which opens the mesh and forgets it again."""
    drawn = talweg.read_curves(drawing_of(path))
    result = talweg.read_mesh(path).smooth(drawn, tau=1)
    talweg.write_curves(results / f"{path.stem}.vtp", result.curves)
    try:
        result.show(file=results / f"{path.stem}.png", size=(480, 360))
    except talweg.Unsupported:  # no matplotlib
        pass
    row = {name: getattr(result.total, name, None) for name in COLUMNS}
    return {**row, "mesh": path.name, "warnings": " ".join(result.total.warnings)}


def attempt(job: Tuple[Path, Path]) -> Dict[str, Any]:
    try:
        return smoothed(*job)
    except Exception as error:  # whatever it is, it is this mesh's; talweg.Error has a clear sentence
        return {"mesh": job[0].name, "error": " ".join(str(error).split())}


def smooth_folder(meshes: Path, results: Path, jobs: int = 2) -> List[Dict[str, Any]]:
    """A row for each mesh, in the order of their names, whichever was ready first."""
    results.mkdir(parents=True, exist_ok=True)
    paths = sorted(path for path in meshes.iterdir() if path.suffix.lower() in FORMATS)
    with ProcessPoolExecutor(jobs) as pool:
        rows = list(pool.map(attempt, [(path, results) for path in paths]))
    with open(results / "summary.csv", "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    return rows


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(str(__doc__).split("\n\n", maxsplit=2)[1])
    for row in smooth_folder(Path(sys.argv[1]), Path(sys.argv[2]), int((sys.argv + ["2"])[3])):
        print(row["mesh"], row.get("error") or
              f"{row['length_before']:.4g} -> {row['length_after']:.4g} mesh units")
