"""Threads: parallel workspaces give the sequential results, and C code runs without Python's lock."""

import gc
import threading
import unittest
import weakref
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import support
import talweg


class Threads(unittest.TestCase):
    def test_workspaces_on_one_mesh(self):
        mesh = talweg.Mesh(*support.hills())
        drawn = support.staircase()
        taus = [0.25 * k for k in range(16)]
        expected = [mesh.smooth(drawn, tau).curve.positions for tau in taus]
        with ThreadPoolExecutor(4) as pool:
            got = list(pool.map(lambda tau: mesh.smooth(drawn, tau).curve.positions, taus))
        for one, other in zip(got, expected):
            np.testing.assert_array_equal(one, other)

    def test_meshes_opened_side_by_side(self):
        def once(n):
            vertices, faces = support.hills(n)
            drawn = talweg.draw((vertices, faces), [0, n * n - 1])
            return (talweg.smooth((vertices, faces), drawn).curve.positions,
                    talweg.distance((vertices, faces), drawn).distance)

        sizes = [20, 30, 40, 50, 20, 30, 40, 50]
        expected = {n: once(n) for n in set(sizes)}
        with ThreadPoolExecutor(4) as pool:
            for n, got in zip(sizes, pool.map(once, sizes)):
                np.testing.assert_array_equal(got[0], expected[n][0])
                np.testing.assert_array_equal(got[1], expected[n][1])

    def test_python_goes_on_while_c_works(self):
        vertices, faces = support.hills(500)
        opened = threading.Event()

        def open_mesh():
            talweg.Mesh(vertices, faces)  # a call that runs no Python code
            opened.set()

        thread = threading.Thread(target=open_mesh)
        thread.start()
        rounds = 0
        while not opened.wait(0.0005):
            rounds += 1
        thread.join()
        self.assertGreater(rounds, 5)  # with Python's lock held there would be one or two

    def test_a_second_call_meanwhile_is_refused(self):
        work = talweg.Mesh(*support.hills()).workspace(support.staircase(), tau=0.0)
        refused = []

        def progress(_stage, _fraction):
            try:
                work.set(tau=1.0)
            except talweg.BadUsage as error:
                refused.append(str(error))

        work.run(progress=progress)
        self.assertIn("Another call", refused[0])
        self.assertEqual(work.parameters["tau"], 0.0)

    def test_instances_are_destroyed_with_their_owners(self):
        work = talweg.Mesh(*support.hills(20)).workspace(support.staircase(20))
        work.run()
        instance = weakref.ref(work._instance)
        mesh = weakref.ref(work.mesh)
        del work
        gc.collect()
        self.assertIsNone(instance())
        self.assertIsNone(mesh())


if __name__ == "__main__":
    unittest.main()
