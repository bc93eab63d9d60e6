"""dask_test.py EXAMPLES FOLDER: runs docs/examples/dask_curves.py on 1,000 curves on 50 meshes of FOLDER, and
kills a worker meanwhile. The table must have every curve once, and the files must equal those of a run
without dask."""

import collections
import os
import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np
import talweg
from distributed import Client, LocalCluster

sys.path.insert(0, sys.argv[1])
import dask_curves  # noqa: E402

MESHES, CURVES = 50, 20


def drawings(mesh, seed):
    """Lines between random vertices, 20 on each mesh."""
    random = np.random.default_rng(seed)
    drawn = []
    while len(drawn) < CURVES:
        ends = random.integers(len(mesh.vertices), size=2)
        try:
            drawn.append(mesh.draw(ends.tolist()))
        except talweg.Error:  # both ends are the same vertex
            pass
    return drawn


def kill_one(cluster, results):
    """Kills a worker as soon as there are some results."""
    while len(list(results.glob("*.vtp"))) < 5:
        time.sleep(0.02)
    victim = next(iter(cluster.workers.values())).process.pid
    os.kill(victim, signal.SIGKILL)
    print(f"        dask: a worker dies after {len(list(results.glob('*.vtp')))} meshes", flush=True)


def main():
    folder = Path(sys.argv[2])
    (folder / "drawings").mkdir(exist_ok=True)
    cases = []
    for i in range(MESHES):
        path = folder / f"vessels/vessel{i:05}.ply"
        curve = folder / f"drawings/{path.stem}.json"
        talweg.write_curves(curve, drawings(talweg.read_mesh(path), i))
        cases.append({"mesh": str(path), "curve": str(curve), "patient": path.stem})

    results, alone = folder / "dask", folder / "alone"
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, \
            Client(cluster) as client:
        client.run(lambda: sys.path.insert(0, sys.argv[1]))
        client.upload_file(dask_curves.__file__)
        killer = threading.Thread(target=kill_one, args=(cluster, results))
        killer.start()
        rows = dask_curves.smooth_all(client, cases, results)
        killer.join()

    assert not any(row.get("error") for row in rows), [r for r in rows if r.get("error")][:3]
    times = collections.Counter((row["patient"], row["number"]) for row in rows)
    assert len(times) == MESHES * CURVES and set(times.values()) == {1}
    alone.mkdir(exist_ok=True)
    expected = [row for case in cases for row in dask_curves.smoothed(case, str(alone))]
    assert rows == expected
    for path in alone.iterdir():
        assert (results / path.name).read_bytes() == path.read_bytes(), path
    print(f"        dask: {len(rows)} curves, each once, as without dask")


if __name__ == "__main__":
    main()
