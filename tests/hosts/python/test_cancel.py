"""Progress, cancel and Ctrl-C: there is no result, and the workspace stays usable."""

import os
import signal
import threading
import time
import unittest

import numpy as np

import support
import talweg


class Cancel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = talweg.Mesh(*support.hills(200))
        cls.drawn = support.staircase(200)
        cls.expected = cls.mesh.smooth(cls.drawn, potential="paper").curve.positions

    def setUp(self):
        self.work = self.mesh.workspace(self.drawn, potential="paper")

    def begin_anew(self):
        """Makes the next run repeat the stage of the curves."""
        for heat_time in (9, None):
            self.work.set(heat_time=heat_time)

    def as_if_nothing_had_been(self):
        np.testing.assert_array_equal(self.work.run().curve.positions, self.expected)

    def test_progress_comes_on_the_callers_thread(self):
        seen, threads = [], set()

        def progress(stage, fraction):
            seen.append((stage, fraction))
            threads.add(threading.current_thread())

        result = self.work.run(progress=progress)
        np.testing.assert_array_equal(result.curve.positions, self.expected)
        self.assertGreater(len(seen), 3)
        self.assertTrue(all(isinstance(stage, str) and 0 <= f <= 1 for stage, f in seen))
        self.assertEqual(threads, {threading.main_thread()})

    def test_false_cancels_at_every_moment(self):
        calls = []
        self.work.run(progress=lambda *at: calls.append(at))
        for last in range(0, len(calls), max(1, len(calls) // 8)):
            self.begin_anew()
            left = [last]

            def progress(_stage, _fraction, left=left):
                left[0] -= 1
                return left[0] >= 0

            with self.assertRaises(talweg.Cancelled):
                self.work.run(progress=progress)
            self.assertEqual(left[0], -1)
        self.as_if_nothing_had_been()

    def test_exceptions_of_progress_reach_the_caller(self):
        def progress(_stage, _fraction):
            raise ZeroDivisionError("in the callback")

        with self.assertRaisesRegex(ZeroDivisionError, "in the callback"):
            self.work.run(progress=progress)
        self.as_if_nothing_had_been()

        caught = []

        def on_a_thread():
            self.begin_anew()
            try:
                self.work.run(progress=progress)
            except ZeroDivisionError as error:
                caught.append(error)

        thread = threading.Thread(target=on_a_thread)
        thread.start()
        thread.join()
        self.assertEqual(len(caught), 1)
        self.as_if_nothing_had_been()

    def test_cancel_from_another_thread(self):
        stop = threading.Event()

        def cancel():
            while not stop.wait(0.001):
                self.work.cancel()

        thread = threading.Thread(target=cancel)
        thread.start()
        try:
            with self.assertRaises(talweg.Cancelled):
                while True:
                    self.begin_anew()
                    self.work.run()
        finally:
            stop.set()
            thread.join()
        self.as_if_nothing_had_been()

    def interrupted(self, seconds, step):
        """Repeats step() until a signal arrives after this many seconds."""
        timer = threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT))
        patience = time.monotonic() + seconds + 5
        with self.assertRaises(KeyboardInterrupt):
            timer.start()  # the signal may arrive at once
            while True:
                step()
                # Python drops exceptions in finalizers; the signal is sent again.
                if time.monotonic() > patience:
                    os.kill(os.getpid(), signal.SIGINT)
        timer.join()

    def solve_anew(self):
        self.begin_anew()
        self.work.run()

    def test_ctrl_c(self):
        for k in range(8):
            self.interrupted(0.01 + 0.017 * k, self.solve_anew)
        self.as_if_nothing_had_been()

    def test_ctrl_c_anywhere_in_short_calls(self):
        vertices, faces = support.hills(12)
        work = talweg.Mesh(vertices, faces).workspace([13, 14, 26, 38, 39, 40])
        expected = work.run().curve.positions

        def step():
            work.smooth(0.0)
            work.smooth(1.0)

        for k in range(60):
            self.interrupted(0.002 + 0.000173 * k, step)
            np.testing.assert_array_equal(work.smooth(1.0).curve.positions, expected)

    def test_ctrl_c_while_the_mesh_is_opened(self):
        vertices, faces = support.hills(300)
        self.interrupted(0.05, lambda: talweg.Mesh(vertices, faces))
        self.as_if_nothing_had_been()

    def test_a_bar_of_tqdm(self):
        class Bar:  # the interface of a tqdm bar
            total, n, shown, stages = 1, 0.0, [], []

            def set_description(self, text, refresh=True):
                self.stages.append(text)

            def refresh(self):
                self.shown.append(self.n)

        bar = Bar()
        self.work.run(progress=bar)
        self.assertGreater(len(bar.shown), 3)
        self.assertEqual(len(bar.shown), len(bar.stages))
        self.assertEqual(max(bar.shown), 1)
        self.assertEqual(bar.shown[-1], 1)


if __name__ == "__main__":
    unittest.main()
