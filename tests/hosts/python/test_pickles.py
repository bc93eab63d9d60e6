"""All objects pickle without a change, also into another process."""

import copy
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import support
import talweg


def again(thing):
    return pickle.loads(pickle.dumps(thing))


class Pickles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.vertices, cls.faces = support.hills(30)
        cls.drawn = support.staircase(30)
        cls.mesh = talweg.Mesh(cls.vertices, cls.faces,
                               face_attributes={"label": np.arange(len(cls.faces))})
        cls.result = cls.mesh.smooth(cls.drawn, 2, point_fields=True, vertex_fields=True)

    def same_curve(self, one, other):
        for name in ("vertices", "faces", "barycentrics", "positions", "exact"):
            np.testing.assert_array_equal(getattr(one, name), getattr(other, name), name)
        self.assertEqual((one.closed, one.pins, set(one.fields)),
                         (other.closed, other.pins, set(other.fields)))
        for name, values in one.fields.items():
            np.testing.assert_array_equal(values, other.fields[name])

    def test_mesh(self):
        for mesh in (again(self.mesh), copy.deepcopy(self.mesh)):
            np.testing.assert_array_equal(mesh.vertices, self.vertices)
            np.testing.assert_array_equal(mesh.face_attributes["label"], np.arange(len(self.faces)))
            self.same_curve(mesh.smooth(self.drawn, 2, point_fields=True).curve, self.result.curve)
            self.assertEqual(repr(mesh), "<talweg.Mesh: 900 vertices, 1682 faces>")

    def test_mesh_of_views(self):
        wide = np.full((len(self.vertices), 7), np.nan, np.float32)
        wide[:, 2:5] = self.vertices
        mesh = again(talweg.Mesh(wide[:, 2:5], self.faces[:]))
        self.assertLess(len(pickle.dumps(mesh)), wide.nbytes + self.faces.nbytes)
        np.testing.assert_array_equal(mesh.vertices, wide[:, 2:5])

    def test_curve(self):
        self.same_curve(again(self.result.curve), self.result.curve)
        given = talweg.Curve([1, 2, 3], closed=True, pins=[1], exact=True)
        self.assertEqual(again(given).vertices, given.vertices)
        self.assertEqual((again(given).exact, again(given).pins), (True, [1]))

    def test_result(self):
        result = again(self.result)
        self.same_curve(result.curve, self.result.curve)
        self.assertEqual(result.report, self.result.report)
        self.assertEqual(result.total, self.result.total)
        np.testing.assert_array_equal(result.fields["distance"], self.result.fields["distance"])
        np.testing.assert_array_equal(result.drawn[0].vertices, self.drawn)
        self.same_curve(result.mesh.smooth(result.drawn, 2, point_fields=True).curve, result.curve)

    def test_results_share_their_mesh(self):
        """A pickle has a mesh once, for any number of results on it."""
        several = [self.mesh.smooth(self.drawn, tau) for tau in (0.5, 1, 2)]
        self.assertIs(several[0].mesh, several[1].mesh)
        self.assertTrue(np.shares_memory(several[0].mesh.vertices, self.vertices))
        one = len(pickle.dumps(several[:1]))
        self.assertLess(len(pickle.dumps(several)), one + 0.5 * self.vertices.nbytes)

    def test_results_do_not_keep_opened_meshes(self):
        self.assertEqual(self.result.mesh._owners, {})  # pylint: disable=protected-access

    def test_workspace(self):
        work = self.mesh.workspace(self.drawn, slack=0.4, pin=[int(self.drawn[20])])
        expected = work.smooth(3)
        other = again(work)
        self.assertEqual(other.parameters, work.parameters)
        self.same_curve(other.run().curve, expected.curve)
        self.assertEqual(other.run().report.slack, 0.4)
        each = self.mesh.workspace([talweg.Curve(self.drawn)], tau=[3], slack=[0.4])
        self.same_curve(again(each).run().curve, each.run().curve)
        self.assertEqual(again(self.mesh.workspace()).plugin.id, "talweg.smooth")

    def test_distance_and_description(self):
        distance = again(self.mesh.distance(self.drawn))
        self.assertEqual(distance.distance.shape, (len(self.vertices),))
        plugin = talweg.plugin("talweg.smooth")
        self.assertIs(again(plugin), plugin)
        self.assertEqual(again(plugin.parameters), plugin.parameters)

    def test_errors(self):
        kinds = [kind for kind in vars(talweg).values()
                 if isinstance(kind, type) and issubclass(kind, talweg.Error)]
        self.assertGreater(len(kinds), 10)
        for kind in kinds:
            error = again(kind("It does not work."))
            self.assertEqual((type(error), str(error), error.code),
                             (kind, "It does not work.", kind.code))

    def test_in_another_process(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "result.pickle"
            path.write_bytes(pickle.dumps((self.mesh, self.result)))
            code = ("import pickle, sys, numpy as np; mesh, result = pickle.load(open(sys.argv[1], 'rb'))\n"
                    "again = mesh.smooth(result.drawn, 2).curve.positions\n"
                    "print(np.array_equal(again, result.curve.positions))")
            done = subprocess.run([sys.executable, "-c", code, path], text=True, check=True,
                                  capture_output=True)
            self.assertEqual(done.stdout.strip(), "True")


if __name__ == "__main__":
    unittest.main()
