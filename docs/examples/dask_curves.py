"""Smooths the curves of many meshes with dask, one task a mesh, which opens it once.

usage: dask_curves.py CASES RESULTS [SCHEDULER]

CASES is a table (CSV) with the columns mesh, curve and patient; a curve file may hold many curves, each
of which is smoothed by itself. RESULTS gets PATIENT.vtp and summary.csv with a row for each curve.
SCHEDULER is the address of a running one; without, this machine's cores work. What cannot be done is a
row that says why. Needs dask.distributed (Debian: python3-distributed).
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path
from typing import Any, Dict, List

from distributed import Client, as_completed

import talweg

COLUMNS = ("patient", "number", "length_before", "length_after", "bending_after",
           "deviation_to_drawn_max", "error")


def smoothed(case: Dict[str, str], results: str) -> List[Dict[str, Any]]:
    """A row for each curve of a mesh. Runs in a worker; doing it again gives the same files."""
    rows: List[Dict[str, Any]] = []
    try:
        mesh = talweg.read_mesh(case["mesh"])
        curves = []
        for number, drawn in enumerate(talweg.read_curves(case["curve"])):
            row: Dict[str, Any] = {"patient": case["patient"], "number": number}
            try:
                result = mesh.smooth(drawn, tau=2)
                curves.append(result.curve)
                row.update({name: getattr(result.report, name) for name in COLUMNS[2:-1]})
            except talweg.Error as error:
                row["error"] = str(error)
            rows.append(row)
        if curves:
            talweg.write_curves(Path(results) / f"{case['patient']}.vtp", curves)
    except (talweg.Error, OSError) as error:
        rows.append({"patient": case["patient"], "error": str(error)})
    return rows


def smooth_all(client: Client, cases: List[Dict[str, str]], results: Path) -> List[Dict[str, Any]]:
    """All rows, in the order of the cases, whichever was ready first."""
    results.mkdir(parents=True, exist_ok=True)
    tasks = {client.submit(smoothed, case, str(results), pure=False): i for i, case in enumerate(cases)}
    rows: List[List[Dict[str, Any]]] = [[] for _ in cases]
    for task in as_completed(tasks):
        # An error here is the cluster's, such as a task during which worker after worker has died.
        error = task.exception()
        i = tasks[task]
        rows[i] = [{"patient": cases[i]["patient"], "error": str(error)}] if error else task.result()
    return [row for of_case in rows for row in of_case]


def main() -> int:
    if len(sys.argv) not in (3, 4):
        print(__doc__, file=sys.stderr)
        return 1
    with open(sys.argv[1], newline="", encoding="utf-8") as table:
        cases = list(csv.DictReader(table))
    results = Path(sys.argv[2])
    with Client(sys.argv[3]) if len(sys.argv) == 4 else Client(threads_per_worker=1) as client:
        rows = smooth_all(client, cases, results)
    with open(results / "summary.csv", "w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, COLUMNS)
        writer.writeheader()
        writer.writerows(rows)
    failed = sum(bool(row.get("error")) for row in rows)
    print(f"{len(rows)} curves on {len(cases)} meshes, {failed} failed")
    return 2 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
