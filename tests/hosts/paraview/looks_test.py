"""A curve begins as a wide line in a colour of its own. Nothing is rendered."""

import pathlib
import tempfile
import unittest

import runner
from support import Case, polydata, pv, source, wavy_sheet

N = 12
POINTS, TRIANGLES = wavy_sheet(N)


def shown(filter, port=0):
    view = pv.CreateView("RenderView")
    return pv.Show(pv.OutputPort(filter, port), view)


class Looks(Case):
    def setUp(self):
        pv.ResetSession()

    def test_a_curve_is_wide_and_not_white(self):
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata(POINTS, TRIANGLES)), PointIds="0 5 80")
        filter.UpdatePipeline()
        curve = shown(filter)
        self.assertGreaterEqual(curve.LineWidth, 3)
        self.assertGreater(max(curve.DiffuseColor) - min(curve.DiffuseColor), 0.4)
        self.assertEqual(curve.ColorArrayName[1], "")  # until the user chooses an array
        mesh = shown(filter, 1)
        self.assertEqual(mesh.LineWidth, 1)

    def test_the_colours_of_the_mesh_are_not_taken_over(self):
        """By default ParaView would colour the curve by the mesh's array, so that it could not be seen."""
        mesh = pv.Elevation(Input=source(polydata(POINTS, TRIANGLES)))
        view = pv.CreateView("RenderView")
        pv.ColorBy(pv.Show(mesh, view), ("POINTS", "Elevation"))
        filter = pv.TalwegSmoothVertices(Mesh=mesh, PointIds="0 5 80")
        filter.UpdatePipeline()
        self.assertEqual(pv.Show(pv.OutputPort(filter, 0), view).ColorArrayName[1], "")

    def test_properties_of_a_state_file_stay(self):
        filter = pv.TalwegSmoothVertices(Mesh=pv.Sphere(), PointIds="0 5 40")
        filter.UpdatePipeline()
        shown(filter).LineWidth = 1
        with tempfile.TemporaryDirectory() as folder:
            state = str(pathlib.Path(folder) / "state.pvsm")
            pv.SaveState(state)
            pv.ResetSession()
            pv.LoadState(state)
        (again,) = [s for (name, _), s in pv.GetSources().items() if "Smooth" in name]
        widths = [r.LineWidth for view in pv.GetViews() for r in view.Representations
                  if r.Input == again]
        self.assertEqual(widths, [1])


if __name__ == "__main__":
    runner.main()
