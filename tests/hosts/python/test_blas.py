"""numpy uses the same OpenBLAS: a call restores its number of threads, and the number changes no byte of a
result."""

import hashlib
import os
import subprocess
import sys
import unittest
from pathlib import Path

import support

FOLDERS = {name: folder for name in ("serial", "pthread", "openmp")
           for folder in Path("/usr/lib").glob(f"*/openblas-{name}")}


def distances():
    """Prints OpenBLAS' number of threads before and after a call, and a hash of the call's result."""
    import ctypes
    import numpy as np
    import talweg

    blas = ctypes.CDLL("libblas.so.3")  # the library that CHOLMOD has loaded
    before = blas.openblas_get_num_threads()
    matrix = np.ones((200, 200)) @ np.ones((200, 200))
    result = talweg.distance(support.torus(150), support.ring(150), potential="paper").distance
    after = blas.openblas_get_num_threads()
    assert matrix[0, 0] == 200
    print(before, after, hashlib.sha256(result.tobytes()).hexdigest())


def two_plugins_at_once():
    """Prints the number of results of two plugins on two threads that differ from sequential results."""
    import threading
    import numpy as np
    import talweg

    vertices, faces = support.torus(80)
    drawn = support.ring(80)

    def smooth():
        return talweg.smooth((vertices, faces), drawn, closed=True, potential="paper").curve.positions

    def distance():
        return talweg.distance((vertices, faces), drawn, closed=True, potential="paper").distance

    wrong = []

    def work(job, expected):
        for _ in range(8):
            try:
                if not np.array_equal(job(), expected):
                    wrong.append("other bytes")
            except talweg.Error as error:
                wrong.append(str(error))

    threads = [threading.Thread(target=work, args=(job, job())) for job in (smooth, distance)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    print(len(wrong), *wrong[:2])


def run(name, openblas, threads):
    """The output of a function of this file in a new process."""
    return subprocess.run(
        [sys.executable, __file__, name], check=True, capture_output=True, text=True,
        env=os.environ | {"LD_LIBRARY_PATH": str(FOLDERS[openblas]),
                          "OPENBLAS_NUM_THREADS": str(threads)}).stdout


class Blas(unittest.TestCase):
    @unittest.skipUnless(len(FOLDERS) == 3, "needs every OpenBLAS (libopenblas0-serial, -pthread, -openmp)")
    def test_two_plugins_at_once(self):
        for openblas in FOLDERS:
            self.assertEqual(run("two_plugins_at_once", openblas, 2), "0\n", openblas)

    @unittest.skipUnless("pthread" in FOLDERS, "needs OpenBLAS with threads (libopenblas0-pthread)")
    def test_threads_are_put_back_and_change_nothing(self):
        results = set()
        for threads in (1, 2, 8):
            before, after, result = run("distances", "pthread", threads).split()
            self.assertEqual(before, after)
            results.add(result)
            if threads <= os.cpu_count():
                self.assertEqual(int(before), threads)
        self.assertEqual(len(results), 1)


if __name__ == "__main__":
    {"distances": distances, "two_plugins_at_once": two_plugins_at_once}.get(
        "".join(sys.argv[1:]), unittest.main)()
