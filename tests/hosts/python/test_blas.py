"""OpenBLAS is numpy's, too: its threads are as before after a call, and change no byte of a result."""

import hashlib
import os
import subprocess
import sys
import unittest
from pathlib import Path

import support

FOLDERS = list(Path("/usr/lib").glob("*/openblas-pthread"))


def distances():
    """Prints OpenBLAS' number of threads before and after a call, and the call's result in short."""
    import ctypes
    import numpy as np
    import talweg

    blas = ctypes.CDLL("libblas.so.3")  # the one that CHOLMOD has loaded
    before = blas.openblas_get_num_threads()
    matrix = np.ones((200, 200)) @ np.ones((200, 200))
    result = talweg.distance(*support.torus(150), support.ring(150), potential="paper").distance
    after = blas.openblas_get_num_threads()
    assert matrix[0, 0] == 200
    print(before, after, hashlib.sha256(result.tobytes()).hexdigest())


class Blas(unittest.TestCase):
    @unittest.skipUnless(FOLDERS, "needs OpenBLAS with threads (libopenblas0-pthread)")
    def test_threads_are_put_back_and_change_nothing(self):
        results = set()
        for threads in (1, 2, 8):
            done = subprocess.run(
                [sys.executable, __file__, "distances"], check=True, capture_output=True, text=True,
                env=os.environ | {"LD_LIBRARY_PATH": str(FOLDERS[0]),
                                  "OPENBLAS_NUM_THREADS": str(threads)})
            before, after, result = done.stdout.split()
            self.assertEqual(before, after)
            results.add(result)
            if threads <= os.cpu_count():
                self.assertEqual(int(before), threads)
        self.assertEqual(len(results), 1)


if __name__ == "__main__":
    distances() if sys.argv[1:] == ["distances"] else unittest.main()
