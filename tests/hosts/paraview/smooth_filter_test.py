"""The filter's outputs, its three kinds of drawing, wrong input, abort, and the stages that a change
repeats."""

import math
import pathlib
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkLogger

import runner
from support import (Case, Said, cell_values, column, counts, lines_of, output, places, polydata, pv,
                     real_mesh, reference_curve, report, source, told, values, wavy_sheet)

N = 24
POINTS, TRIANGLES = wavy_sheet(N)
# A wave with a jagged line; consecutive vertices are not neighbours.
ZIGZAG = [N * row + 11 + round(6 * math.sin(row / 3)) + (1 if row % 2 else -1)
          for row in range(2, N - 2)]
LOOP = [N * 4 + 4, N * 4 + 16, N * 16 + 16, N * 16 + 4]
TEXT = " ".join(map(str, ZIGZAG))


def quads():
    return [(N * r + c, N * r + c + 1, N * r + c + N + 1, N * r + c + N)
            for r in range(N - 1) for c in range(N - 1)]


def sheet(**properties):
    filter = pv.TalwegSmoothPoints if "Points" in properties else pv.TalwegSmoothVertices
    return filter(Mesh=source(polydata(POINTS, TRIANGLES)), **properties)


def two_curves(**properties):
    drawn = [POINTS[v] for v in (N + 2, 9 * N + 2, N + 12, 9 * N + 12)]
    return pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)),
                                Curve=source(polydata(drawn, lines=[(0, 1), (2, 3)])), **properties)


def taus(filter):
    """The tau of each curve in the report."""
    return column(output(filter, 2), "tau")[:-1]


def distance(a, b):
    return math.dist(a, b)


class Outputs(Case):
    def test_points_lie_where_their_faces_and_barycentrics_say(self):
        curve = self.curve_of(sheet(PointIds=TEXT))
        for place, face, weights, vertex in zip(places(curve), values(curve, "face"),
                                                values(curve, "barycentric"), values(curve, "vertex")):
            corners = [POINTS[v] for v in TRIANGLES[int(face)]]
            self.assertAlmostEqual(sum(weights), 1, 12)
            self.assertGreaterEqual(min(weights), 0)
            there = [sum(w * corner[k] for w, corner in zip(weights, corners)) for k in range(3)]
            self.assertLess(distance(place, there), 1e-12)
            if vertex >= 0:
                self.assertEqual(place, POINTS[int(vertex)])

    def test_a_point_and_the_next_lie_in_one_face(self):
        curve = self.curve_of(sheet(PointIds=TEXT))
        points = places(curve)
        for k, face in enumerate(values(curve, "face")[:-1]):
            a, b, c = (POINTS[v] for v in TRIANGLES[int(face)])
            u = [b[i] - a[i] for i in range(3)]
            v = [c[i] - a[i] for i in range(3)]
            n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            off = sum(n[i] * (points[k + 1][i] - a[i]) for i in range(3)) / math.hypot(*n)
            self.assertLess(abs(off), 1e-12)

    def test_the_curve_is_smoother_and_ends_where_the_drawing_does(self):
        curve = self.curve_of(sheet(PointIds=TEXT))
        self.assertEqual(places(curve)[0], POINTS[ZIGZAG[0]])
        self.assertEqual(places(curve)[-1], POINTS[ZIGZAG[-1]])
        self.assertLess(report(curve, "curvature_after"), 0.5 * report(curve, "curvature_before"))
        length = sum(distance(a, b) for a, b in zip(places(curve), places(curve)[1:]))
        self.assertAlmostEqual(report(curve, "length_after"), length, 9)
        self.assertEqual(report(curve, "termination"), "converged")
        self.assertEqual(report(curve, "tau"), 1)

    def test_deviation_is_that_of_the_report_and_the_ends_do_not_turn(self):
        curve = self.curve_of(sheet(PointIds=TEXT))
        largest = max(values(curve, "deviation"))
        self.assertGreater(largest, 0)
        self.assertLessEqual(largest, report(curve, "deviation_to_drawn_max") * (1 + 1e-9))
        turns = values(curve, "turning")
        self.assertEqual((turns[0], turns[-1]), (0, 0))
        self.assertAlmostEqual(sum(map(abs, turns)), report(curve, "curvature_after"), 9)

    def test_arc_length_runs_along_each_curve(self):
        curves = self.curve_of(two_curves())
        arcs = values(curves, "arc_length")
        for line in lines_of(curves):
            length = 0
            for k, point in enumerate(line):
                if k > 0:
                    length += distance(places(curves)[line[k - 1]], places(curves)[point])
                self.assertAlmostEqual(arcs[point], length, 12)

    def test_curves_have_the_arrays_of_the_mesh(self):
        """Linear functions of the place stay linear between the corners; cell arrays are copied."""
        data = polydata(POINTS, TRIANGLES)
        from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray
        heights, numbers = vtkDoubleArray(), vtkIntArray()
        heights.SetName("height")
        numbers.SetName("number")
        for x, y, z in POINTS:
            heights.InsertNextValue(z + 2 * x)
        for k in range(len(TRIANGLES)):
            numbers.InsertNextValue(7 * k)
        data.GetPointData().SetScalars(heights)
        data.GetCellData().AddArray(numbers)
        curve = self.curve_of(pv.TalwegSmoothVertices(Mesh=source(data), PointIds=TEXT))
        for (x, y, z), height in zip(places(curve), values(curve, "height")):
            self.assertAlmostEqual(height, z + 2 * x, 12)
        self.assertEqual(values(curve, "number"), [7 * face for face in values(curve, "face")])
        self.assertIsNone(curve.GetPointData().GetScalars())  # the curve keeps its own colour

    def test_the_mesh_has_the_distance_to_the_drawing(self):
        filter = sheet(PointIds=TEXT, DistanceField=1)
        self.curve_of(filter)
        mesh = output(filter, 1)
        self.assertEqual((mesh.GetNumberOfPoints(), mesh.GetNumberOfPolys()),
                         (len(POINTS), len(TRIANGLES)))
        field = values(mesh, "distance")
        for v in ZIGZAG:
            self.assertEqual(field[v], 0)
        # The distance along the surface is at least the distance through space to the nearest edge of the
        # drawing, which is at least the distance to the nearest vertex minus an edge.
        longest = max(distance(POINTS[a], POINTS[b]) for a, b, _ in TRIANGLES)
        for v, point in enumerate(POINTS):
            nearest = min(distance(point, POINTS[w]) for w in ZIGZAG)
            self.assertGreaterEqual(field[v], nearest - 2 * longest)

    def test_the_distance_is_given_on_request(self):
        filter = sheet(PointIds=TEXT)
        self.curve_of(filter)
        self.assertIsNone(output(filter, 1).GetPointData().GetArray("distance"))
        filter.DistanceField = 1
        self.curve_of(filter)
        first = values(output(filter, 1), "distance")
        self.assertEqual(len(first), len(POINTS))
        filter.Tau = 5
        self.curve_of(filter)
        self.assertEqual(values(output(filter, 1), "distance"), first)
        filter.PointIds = " ".join(map(str, LOOP))
        self.curve_of(filter)
        self.assertEqual(values(output(filter, 1), "distance")[LOOP[0]], 0)

    def test_the_log_tells_what_was_done(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder) / "log.txt"
            vtkLogger.LogToFile(str(log), vtkLogger.TRUNCATE, vtkLogger.VERBOSITY_INFO)
            self.curve_of(sheet(PointIds=TEXT))
            vtkLogger.EndLogToFile(str(log))
            self.assertRegex(log.read_text(), "Talweg: length .* curvature .*: converged")

    def test_a_warning_is_not_repeated_while_it_is_so(self):
        """Each click makes another drawing, and ParaView opens its window of messages for each warning."""
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata(POINTS, quads())), PointIds=TEXT)
        said = []
        for change in ({"Tau": 1}, {"Tau": 2}, {"PointIds": " ".join(map(str, LOOP))}):
            pv.SetProperties(filter, **change)
            with Said() as now:
                filter.UpdatePipeline()
            said.append("polygons were cut" in now.text())
        self.assertEqual(said, [True, False, False])

    def test_a_warning_that_was_over_is_given_again(self):
        edge = 1 / (N - 1)
        lifted = lambda height: [c for v in LOOP for c in (*POINTS[v][:2], POINTS[v][2] + height)]
        filter = sheet(Points=lifted(0))
        said = []
        for height in (6 * edge, 0, 6 * edge):
            filter.Points = lifted(height)
            said.append(len(self.update(filter)))
        self.assertEqual(said, [1, 0, 1])

    def test_a_drawing_that_is_moved_to_the_mesh_is_no_warning_but_reported(self):
        filter = sheet(Points=[c for v in LOOP for c in (*POINTS[v][:2], POINTS[v][2] + 0.01)])
        with Said() as said:
            filter.UpdatePipeline()
        self.assertEqual(said.text(), "")
        self.assertIn("moved onto the mesh", report(output(filter, 0), "warnings"))


    def test_a_bound_instead_of_a_deviation_is_no_warning_but_reported(self):
        """A drawing around three sides of a sheet of needles, where measuring takes far longer than
        smoothing."""
        wide, high = 800, 6
        points = [(4 * i / wide, j, 0) for j in range(high + 1) for i in range(wide + 1)]
        corners = [(wide + 1) * j + i for j in range(high) for i in range(wide)]
        triangles = [triangle for a in corners for triangle in (
            (a, a + 1, a + wide + 2), (a, a + wide + 2, a + wide + 1))]
        way = [(wide + 1) * j + i for i, j in ((200, 1), (200, 6), (600, 6), (600, 2))]
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata(points, triangles)),
                                         PointIds=" ".join(map(str, way)), Slack=4)
        self.assertEqual(self.update(filter), [])
        self.assertIn("exact deviation was not measured", told(filter))
        self.assertEqual(report(output(filter, 0), "deviation_exact"), 0)


class Begin(Case):
    """The first state of a new filter."""

    def test_points_begin_on_the_mesh(self):
        for scale, offset in ((1, 0), (0.01, 5), (1000, -300)):
            there = [tuple(scale * c + offset for c in point) for point in POINTS]
            mesh = source(polydata(there, TRIANGLES))
            mesh.UpdatePipeline()
            filter = pv.TalwegSmoothPoints(Mesh=mesh)
            clicked = [tuple(filter.Points[3 * k:3 * k + 3]) for k in range(3)]
            self.assertEqual(len(filter.Points), 9)
            curve = self.curve_of(filter)
            self.assertEqual(self.update(filter), [])
            spread = max(distance(a, b) for a in clicked for b in clicked)
            self.assertGreater(spread, 0.3 * scale)
            for point in clicked:
                nearest = min(distance(point, place) for place in places(curve))
                self.assertLess(nearest, 1e-9 * (scale + abs(offset)))

    def test_points_begin_where_a_mesh_with_a_gap_is_seen(self):
        """The middle of the mesh's box is a gap, so that the point nearest to it is not visible."""
        n = 25
        points, triangles = wavy_sheet(n)
        kept = [corners for corners in triangles
                if all(0.3 > points[v][1] or points[v][1] > 0.7 or points[v][0] > 0.9
                       for v in corners)]
        mesh = source(polydata(points, kept))
        mesh.UpdatePipeline()
        points_of = lambda filter: [filter.Points[k:k + 3] for k in (0, 3, 6)]
        for _, y, _ in points_of(pv.TalwegSmoothPoints(Mesh=mesh)):
            self.assertTrue(y < 0.28 or y > 0.72, y)

    def test_points_begin_where_they_are_seen_from_close_by(self):
        """From close by, only a small cap of a ball is visible."""
        ball = pv.Sphere(Radius=1, ThetaResolution=64, PhiResolution=64)
        ball.UpdatePipeline()
        view = pv.CreateView("RenderView")
        view.CameraPosition, view.CameraFocalPoint = [0, 0, 1.1], [0, 0, 0]
        points = pv.TalwegSmoothPoints(Mesh=ball).Points
        self.assertGreater(distance(points[:3], points[6:]), 0.05)
        for height in points[2::3]:
            self.assertGreater(height, 1 / 1.1 - 0.01)
        view.CameraParallelProjection = 1
        for height in pv.TalwegSmoothPoints(Mesh=ball).Points[2::3]:
            self.assertGreater(height, 0)
        pv.Delete(view)

    def test_no_ray_falls_between_faces(self):
        """In the middle plane of a mesh, rounding decides in which cell a ray is searched."""
        points, triangles = wavy_sheet(25)
        mesh = source(polydata([(x + 0.3, y + 0.3, z) for x, y, z in points], triangles))
        mesh.UpdatePipeline()
        view = pv.CreateView("RenderView")
        middles = set()
        for k in range(-8, 9):
            x = 0.8 + k * math.ulp(0.8)
            view.CameraPosition, view.CameraFocalPoint = [x, 0.8, 5], [x, 0.8, 0]
            middles.add(tuple(round(number, 9) for number in pv.TalwegSmoothPoints(Mesh=mesh).Points[3:6]))
        self.assertEqual(len(middles), 1, middles)
        pv.Delete(view)

    def test_points_of_a_mesh_in_two_parts_are_on_one(self):
        beside = [(x + 2, y, z) for x, y, z in POINTS[:3 * N]]
        parts = TRIANGLES + [tuple(v + len(POINTS) for v in corners) for corners in TRIANGLES
                             if max(corners) < 3 * N]
        mesh = source(polydata(POINTS + beside, parts))
        mesh.UpdatePipeline()
        filter = pv.TalwegSmoothPoints(Mesh=mesh)
        self.assertLess(max(filter.Points[::3]), 1.5)
        self.curve_of(filter)

    def test_given_points_stay(self):
        clicks = [c for v in LOOP for c in POINTS[v]]
        self.assertEqual(list(sheet(Points=clicks).Points), clicks)

    def test_one_sentence_without_a_drawing(self):
        mesh = source(polydata(POINTS, TRIANGLES))
        mesh.UpdatePipeline()
        curve = pv.TalwegSmoothCurve(Mesh=mesh, Curve=None)
        self.assertIn("No curve is given: choose one for the input Curve", self.error_of(curve))
        points = pv.TalwegSmoothPoints(Mesh=mesh, Points=[])
        points.Points = []
        self.assertIn("click some on the mesh", self.error_of(points))
        self.assertIn("Point Ids", self.error_of(pv.TalwegSmoothVertices(Mesh=mesh)))

    def test_inputs_are_called_mesh_and_curve(self):
        filter = two_curves()
        self.assertEqual([filter.SMProxy.GetProperty(name).GetXMLLabel()
                          for name in ("Input", "Curve")], ["Mesh", "Curve"])


class Told(Case):
    """The panel's text on the last run."""

    def test_slack_used_and_deviation_reached(self):
        filter = sheet(PointIds=TEXT)
        self.assertEqual(told(filter), "")
        curve = self.curve_of(filter)
        self.assertEqual(told(filter, "SlackUsed"), report(curve, "slack"))
        self.assertGreater(told(filter, "SlackUsed"), 0)
        self.assertEqual(told(filter, "DeviationReached"),
                         max(report(curve, "deviation_to_drawn_max"),
                             report(curve, "deviation_from_drawn_max")))
        self.assertIn(f"at most {told(filter, 'DeviationReached'):.4g},", told(filter))
        filter.Slack = 0.05
        self.curve_of(filter)
        self.assertEqual(told(filter, "SlackUsed"), 0.05)

    def test_why_there_is_no_result(self):
        filter = sheet(PointIds=TEXT, Tau=-1)
        self.error_of(filter)
        self.assertEqual(told(filter), "No result: Tau must be >= 0, not -1.")
        filter.Tau = 1
        self.curve_of(filter)
        self.assertNotIn("No result", told(filter))

    def test_points_far_from_the_mesh(self):
        """Close points cause no warning, farther points a warning, and points far away an error."""
        edge = 1 / (N - 1)
        lifted = lambda height: [c for v in LOOP for c in (*POINTS[v][:2], POINTS[v][2] + height)]
        filter = sheet(Points=lifted(1e-9))
        self.assertEqual(self.update(filter), [])
        self.assertNotIn("moved", told(filter))
        filter.Points = lifted(6 * edge)
        (warning,) = self.update(filter)
        for text in (warning, told(filter)):
            self.assertRegex(text, r"far from the mesh.*0\.2.* mean edges")
        filter.Points = lifted(100)
        self.assertRegex(self.error_of(filter), "in another unit or place.*Transform")
        self.assertIn("Transform", told(filter))
        self.assertNotIn("..", told(filter))

    def test_points_are_counted_as_in_the_table(self):
        clicks = [list(POINTS[v]) for v in LOOP]
        clicks[1][2] += 100
        filter = sheet(Points=[c for point in clicks for c in point])
        self.assertRegex(self.error_of(filter), "At point 2: the mesh, which is [0-9.]+ large, lies [0-9.]+ away")

    def test_where_the_distance_is(self):
        filter = sheet(PointIds=TEXT, DistanceField=1)
        self.curve_of(filter)
        self.assertIn("on the output Mesh", told(filter))


class Drawings(Case):
    def test_vertex_numbers_need_not_be_neighbours_and_close(self):
        curve = self.curve_of(sheet(PointIds=", ".join(map(str, LOOP + LOOP[:1]))))
        (line,) = lines_of(curve)
        self.assertEqual(line[0], line[-1])
        self.assertEqual(len(line) - 1, curve.GetNumberOfPoints())
        self.assertEqual(report(curve, "closed"), 1)

    def test_points_are_moved_to_the_mesh(self):
        above = [c for v in LOOP for c in (*POINTS[v][:2], POINTS[v][2] + 0.01)]
        curve = self.curve_of(sheet(Points=above))
        self.assertEqual(report(curve, "closed"), 0)
        self.assertIn("moved onto the mesh", report(curve, "warnings"))
        closed = self.curve_of(sheet(Points=above, Closed=1))
        self.assertEqual(report(closed, "closed"), 1)

    def test_clicked_points_are_passed_unless_they_are_a_stroke(self):
        clicks = [c for v in LOOP for c in POINTS[v]]
        through = places(self.curve_of(sheet(Points=clicks)))
        for v in LOOP:
            self.assertLess(min(distance(place, POINTS[v]) for place in through), 1e-12)
        self.assertEqual(through, places(self.curve_of(sheet(Points=clicks, MaxDeviation=0.01))))
        rough = places(self.curve_of(sheet(Points=clicks, DrawnPoints="rough")))
        self.assertNotEqual(through, rough)

    def test_lines_and_segments_and_points_in_order_are_the_same_drawing(self):
        mesh = source(polydata(POINTS, TRIANGLES))
        drawn = [POINTS[v] for v in ZIGZAG]
        count = len(drawn)
        results = []
        for lines in ([list(range(count))], [(k, k + 1) for k in range(count - 1)], []):
            curve = source(polydata(drawn, lines=lines))
            results.append(places(self.curve_of(pv.TalwegSmoothCurve(Mesh=mesh, Curve=curve))))
        self.assertEqual(results[0], results[1])
        self.assertEqual(results[0], results[2])

    def test_a_loop_that_repeats_its_first_place_is_closed(self):
        data = polydata([POINTS[v] for v in LOOP + LOOP[:1]], lines=[[0, 1, 2, 3, 4]])
        curve = self.curve_of(pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)),
                                                   Curve=source(data)))
        self.assertEqual(report(curve, "closed"), 1)

    def test_two_lines_are_two_curves(self):
        filter = two_curves()
        result = self.curve_of(filter)
        self.assertEqual(result.GetNumberOfLines(), 2)
        self.assertEqual(cell_values(result, "curve"), [0, 1])
        table = output(filter, 2)
        self.assertEqual(column(table, "# curve"), ["0", "1", "all"])
        lengths = column(table, "length_after")
        self.assertAlmostEqual(lengths[0] + lengths[1], lengths[2], 12)
        self.assertAlmostEqual(lengths[2], report(result, "length_after"), 12)
        self.assertEqual(result.GetCellData().GetNumberOfArrays(), 1)  # the rest is in the table

    def test_numbers_of_curves_follow_the_lines_of_the_output(self):
        ids = (N + 2, 9 * N + 2, N + 12, 5 * N + 12, 9 * N + 12)
        drawn = source(polydata([POINTS[v] for v in ids], lines=[(0, 1), (2, 3, 4)]))
        filter = pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)), Curve=drawn,
                                      Taus="0.1 4")
        curves = self.curve_of(filter)
        begins = [values(curves, "vertex")[line[0]] for line in lines_of(curves)]
        self.assertEqual(begins, [N + 12, N + 2])  # segments come last
        self.assertEqual(taus(filter), [0.1, 4])

    def test_blocks_of_a_drawing_are_one_set(self):
        drawn = [POINTS[v] for v in (N + 2, 9 * N + 2, N + 12, 9 * N + 12)]
        blocks = pv.GroupDatasets(Input=[source(polydata(drawn[k:k + 2], lines=[(0, 1)]))
                                         for k in (0, 2)])
        filter = pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)), Curve=blocks)
        self.assertEqual(places(self.curve_of(filter)), places(self.curve_of(two_curves())))
        self.assertEqual(counts(filter), (1, 1, 1))

    def test_ids_of_a_point_array_take_the_place_of_positions(self):
        from vtkmodules.vtkCommonCore import vtkIdTypeArray
        data = polydata([(9, 9, 9)] * len(ZIGZAG), lines=[list(range(len(ZIGZAG)))])
        ids = vtkIdTypeArray()
        ids.SetName("number")
        for v in ZIGZAG:
            ids.InsertNextValue(v)
        data.GetPointData().AddArray(ids)
        filter = pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)),
                                      Curve=source(data), CurveIds="number")
        self.assertEqual(places(self.curve_of(filter)),
                         places(self.curve_of(sheet(PointIds=TEXT))))

    def test_pins_stay(self):
        middle = ZIGZAG[len(ZIGZAG) // 2]
        free = self.curve_of(sheet(PointIds=TEXT, Tau=0))
        self.assertNotIn(middle, values(free, "vertex"))
        held = self.curve_of(sheet(PointIds=TEXT, Tau=0, Pin=str(middle)))
        self.assertIn(middle, values(held, "vertex"))

    def test_a_pin_array_of_the_curve(self):
        from vtkmodules.vtkCommonCore import vtkIntArray
        middle = len(ZIGZAG) // 2
        data = polydata([POINTS[v] for v in ZIGZAG], lines=[list(range(len(ZIGZAG)))])
        pins = vtkIntArray()
        pins.SetName("pin")
        for k in range(len(ZIGZAG)):
            pins.InsertNextValue(1 if k == middle else 0)
        data.GetPointData().AddArray(pins)
        curve = self.curve_of(pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)),
                                                   Curve=source(data), Tau=0))
        self.assertIn(ZIGZAG[middle], values(curve, "vertex"))


class Meshes(Case):
    def test_quads_are_cut_and_it_is_said(self):
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata(POINTS, quads())), PointIds=TEXT)
        with Said() as said:
            filter.UpdatePipeline()
        self.assertIn("polygons were cut into triangles", said.text())
        # The fans from the first corner are the sheet's triangles.
        self.assertEqual(places(output(filter, 0)), places(self.curve_of(sheet(PointIds=TEXT))))
        self.assertEqual(output(filter, 1).GetNumberOfPolys(), len(TRIANGLES))

    def test_strips_are_cut(self):
        data = polydata(POINTS)
        from vtkmodules.vtkCommonDataModel import vtkCellArray
        strips = vtkCellArray()
        for row in range(N - 1):
            strip = [v for c in range(N) for v in (N * row + c, N * (row + 1) + c)]
            strips.InsertNextCell(len(strip), strip)
        data.SetStrips(strips)
        filter = pv.TalwegSmoothVertices(Mesh=source(data), PointIds=TEXT)
        self.curve_of(filter)
        self.assertEqual(output(filter, 1).GetNumberOfPolys(), len(TRIANGLES))

    def test_concave_polygons_are_cut_inside(self):
        # An L of area 3, which the fan from its first corner does not cover.
        points = [(2, 0, 0), (2, 1, 0), (1, 1, 0), (1, 2, 0), (0, 2, 0), (0, 0, 0)]
        mesh = output(pv.TalwegSmoothVertices(Mesh=source(polydata(points, [list(range(6))])),
                                              PointIds="0 5"), 1)
        areas = []
        for k in range(mesh.GetNumberOfCells()):
            a, b, c = (points[mesh.GetCell(k).GetPointId(i)] for i in range(3))
            areas.append(((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2)
        self.assertEqual(len(areas), 4)
        self.assertGreater(min(areas), 0)  # no triangle is inverted
        self.assertAlmostEqual(sum(areas), 3)

    def test_cell_arrays_follow_their_cells(self):
        from vtkmodules.vtkCommonCore import vtkIntArray
        data = polydata(POINTS, quads(), lines=[(0, 1)])  # lines come first in the cells' order
        numbers = vtkIntArray()
        numbers.SetName("number")
        for k in range(data.GetNumberOfCells()):
            numbers.InsertNextValue(k)
        data.GetCellData().AddArray(numbers)
        filter = pv.TalwegSmoothVertices(Mesh=source(data), PointIds=TEXT)
        self.curve_of(filter)
        array = output(filter, 1).GetCellData().GetArray("number")
        self.assertEqual([array.GetTuple1(k) for k in range(array.GetNumberOfTuples())],
                         [1 + k // 2 for k in range(len(TRIANGLES))])

    def test_other_data_sets_give_their_surface(self):
        solid = pv.Wavelet(WholeExtent=[-5, 5, -5, 5, -5, 5])
        filter = pv.TalwegSmoothPoints(Mesh=solid, Points=[-5, -4, 2, -5, 0, 3, -5, 4, 1])
        with Said() as said:
            filter.UpdatePipeline()
        self.assertIn("outer surface", said.text())
        self.assertEqual(report(output(filter, 0), "termination"), "converged")
        before = counts(filter)
        filter.Tau = 4
        self.curve_of(filter)
        self.assertEqual(counts(filter), (before[0], before[1], before[2] + 1))


    def test_each_block_of_a_composite_data_set_is_a_mesh(self):
        lifted = [(x, y, z + 1) for x, y, z in POINTS]
        blocks = pv.GroupDatasets(Input=[source(polydata(points, TRIANGLES))
                                         for points in (POINTS, lifted)])
        filter = pv.TalwegSmoothVertices(Mesh=blocks, PointIds=TEXT)
        curves = self.curve_of(filter)
        alone = places(self.curve_of(sheet(PointIds=TEXT)))
        self.assertEqual(places(curves.GetBlock(0)), alone)
        self.assertEqual(curves.GetBlock(1).GetNumberOfPoints(), len(alone))

    def test_a_drawing_for_each_block(self):
        """A curve of one block cannot lie on the other; as one mesh they have both curves, smoothed
        together."""
        far = [(x + 5, y, z) for x, y, z in POINTS]
        blocks, drawings = (
            pv.GroupDatasets(Input=[source(polydata(points, *cells)) for points in (POINTS, far)])
            for cells in ((TRIANGLES,), ((), [ZIGZAG])))
        with Said() as said:
            pv.TalwegSmoothCurve(Mesh=blocks, Curve=drawings).UpdatePipeline()
        self.assertIn("the filter Merge Blocks makes one mesh of them.", said.text())
        merged = pv.TalwegSmoothCurve(Mesh=pv.MergeBlocks(Input=blocks, OutputDataSetType="Polygonal Mesh"),
                                      Curve=drawings)
        self.assertEqual(len(lines_of(self.curve_of(merged))), 2)


class WrongInput(Case):
    def test_parameters(self):
        filter = sheet(PointIds=TEXT)
        self.curve_of(filter)
        for name, value, good, sentence in (
                ("Tau", -1, 1, "Tau must be >= 0, not -1."),
                ("MaxDeviation", 0, -1, "Max Deviation must be > 0, not 0."),
                ("Pin", "3 x", "", "'x' is not a vertex number"),
                ("Pin", "99999", "", "99999"),
                ("PointIds", "1 2 99999", TEXT, "99999"),
                ("PointIds", "7", TEXT, "two points"),
                ("PointIds", "4 4000000000000", TEXT, "'4000000000000' is not a vertex number")):
            setattr(filter, name, value)
            self.assertIn(sentence, self.error_of(filter))
            setattr(filter, name, good)
            self.curve_of(filter)

    def test_numbers_of_curves(self):
        filter = two_curves()
        before = places(self.curve_of(filter))
        for name, value, sentence in (
                ("Taus", "0.1", "Taus has 1 values for 2 curves."),
                ("Taus", "0.1 4 1", "Taus has 3 values for 2 curves."),
                ("Taus", "1 -3", "Taus must be -1 or >= 0 for curve 1, not -3."),
                ("Taus", "0.1 much", "Taus: 'much' is not a number."),
                ("Slacks", "0.1 0.2x", "Slacks: '0.2x' is not a number."),
                ("Slacks", "nan 1", "Slacks"),
                ("Finishes", "0 0.5", "Finishes must be whole."),
                ("Finishes", "fair taut", "Finishes: 'fair' is not a number.")):
            setattr(filter, name, value)
            self.assertIn(sentence, self.error_of(filter))
            setattr(filter, name, "")
            self.assertEqual(places(self.curve_of(filter)), before)

    def test_parameters_that_do_not_go_together(self):
        filter = sheet(PointIds=TEXT, Slack=0.1, Potential="paper")
        self.assertIn("slack needs the potential corridor.", self.error_of(filter))

    def test_a_field_that_is_not_there(self):
        self.assertIn("no point array nothing", self.error_of(sheet(PointIds=TEXT, SlackField="nothing")))

    def test_meshes(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]
        three_at_an_edge = [(0, 1, 2), (1, 0, 3), (0, 1, 4)]
        for polygons, sentence in ((three_at_an_edge, "edge"), ([], "no faces"),
                                   ([(0, 1)], "Cell 0 of the mesh has 2 corners"),
                                   ([(0, 1, 1)], "uses a vertex twice")):
            filter = pv.TalwegSmoothVertices(Mesh=source(polydata(points, polygons)), PointIds="0 1")
            self.assertIn(sentence, self.error_of(filter))
        infinite = [(0, 0, 0), (math.inf, 0, 0), (0, 1, 0)]
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata(infinite, [(0, 1, 2)])), PointIds="0 1")
        self.assertIn("finite", self.error_of(filter))

    def test_repair_is_offered_only_where_it_helps(self):
        def refusal(points, polygons):
            mesh = source(polydata(points, polygons))
            return self.error_of(pv.TalwegSmoothVertices(Mesh=mesh, PointIds="0 1"))

        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
        self.assertIn("Tick Repair", refusal(points, [(0, 1, 2), (1, 0, 3), (0, 1, 4)]))
        ribbon = [(0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 0, 4), (4, 0, 1)]  # one-sided
        for polygons in ([], ribbon):
            self.assertNotIn("Tick Repair", refusal(points, polygons))
        self.assertIn("Mesh must be a surface", refusal(points, []))

    def test_a_curve_without_points(self):
        filter = pv.TalwegSmoothCurve(Mesh=source(polydata(POINTS, TRIANGLES)),
                                      Curve=source(polydata([])))
        self.assertIn("no points", self.error_of(filter))

    def test_the_same_filter_recovers_with_a_good_mesh(self):
        filter = pv.TalwegSmoothVertices(Mesh=source(polydata([(0, 0, 0)])), PointIds=TEXT)
        self.error_of(filter)
        filter.Mesh = source(polydata(POINTS, TRIANGLES))
        self.assertEqual(places(self.curve_of(filter)), places(self.curve_of(sheet(PointIds=TEXT))))


class Changes(Case):
    """The stages that a change repeats, counted by the filter."""

    def test_only_the_stage_that_a_change_concerns(self):
        filter = sheet(PointIds=TEXT)
        self.curve_of(filter)
        self.assertEqual(counts(filter), (1, 1, 1))
        for tau in (2, 4, 8):
            filter.Tau = tau
            self.curve_of(filter)
        self.assertEqual(counts(filter), (1, 1, 4))
        filter.PointIds = TEXT + f" {ZIGZAG[-1] + N}"
        self.curve_of(filter)
        self.assertEqual(counts(filter), (1, 2, 5))
        filter.Mesh = source(polydata(POINTS, TRIANGLES))
        self.curve_of(filter)
        self.assertEqual(counts(filter), (2, 3, 6))

    def test_values_of_arrays_are_no_new_mesh(self):
        calculator = pv.Calculator(Input=source(polydata(POINTS, TRIANGLES)), Function="coordsX",
                                   ResultArrayName="field")
        filter = pv.TalwegSmoothVertices(Mesh=calculator, PointIds=TEXT)
        self.curve_of(filter)
        calculator.Function = "coordsY"
        self.curve_of(filter)
        self.assertEqual(counts(filter)[0], 1)
        self.assertEqual(values(output(filter, 1), "field"), [point[1] for point in POINTS])

    def test_a_changed_field_is_used(self):
        calculator = pv.Calculator(Input=source(polydata(POINTS, TRIANGLES)), Function="0.02",
                                   ResultArrayName="slack")
        filter = pv.TalwegSmoothVertices(Mesh=calculator, PointIds=TEXT, SlackField="slack")
        narrow = places(self.curve_of(filter))
        calculator.Function = "0.08"
        self.assertNotEqual(places(self.curve_of(filter)), narrow)
        self.assertEqual(counts(filter)[:2], (1, 1))

    def test_points_moved_in_place_are_a_new_mesh(self):
        data = polydata(POINTS, TRIANGLES)
        mesh = source(data)
        filter = pv.TalwegSmoothVertices(Mesh=mesh, PointIds=TEXT)
        before = places(self.curve_of(filter))
        data.GetPoints().SetPoint(ZIGZAG[0], 0.3, 0.1, 0.5)
        data.GetPoints().Modified()
        mesh.GetClientSideObject().Modified()
        filter.MarkModified(None)
        self.assertNotEqual(places(self.curve_of(filter)), before)
        self.assertEqual(counts(filter)[0], 2)

    def test_back_to_a_tau_gives_the_same_bits(self):
        filter = sheet(PointIds=TEXT)
        first = places(self.curve_of(filter))
        filter.Tau = 7
        self.assertNotEqual(places(self.curve_of(filter)), first)
        filter.Tau = 1
        self.assertEqual(places(self.curve_of(filter)), first)


    def test_numbers_of_curves_repeat_the_run_only(self):
        filter = two_curves()
        self.curve_of(filter)
        filter.Taus = "0.1 4"
        self.curve_of(filter)
        self.assertEqual(taus(filter), [0.1, 4])
        self.assertEqual(counts(filter), (1, 1, 2))
        filter.Taus = "-1 2"
        filter.Tau = 5
        self.curve_of(filter)
        self.assertEqual(taus(filter), [5, 2])
        self.assertEqual(counts(filter), (1, 1, 3))


class Abort(Case):
    def test_progress_is_told_and_abort_gives_nothing_and_is_no_error(self):
        filter = sheet(PointIds=TEXT)
        algorithm = filter.GetClientSideObject()
        stages = []

        def watch(caller, _):
            stages.append(caller.GetProgressText())
            if len(stages) == 3:
                caller.SetAbortExecute(1)

        tag = algorithm.AddObserver("ProgressEvent", watch)
        with Said() as said:
            filter.UpdatePipeline()
        self.assertEqual([line for line in said.lines if line[0] == "ErrorEvent"], [])
        self.assertEqual(output(filter, 0).GetNumberOfPoints(), 0)
        self.assertEqual(output(filter, 1).GetNumberOfPoints(), 0)
        self.assertGreaterEqual(len(stages), 3)
        algorithm.RemoveObserver(tag)
        algorithm.SetAbortExecute(0)
        filter.Tau = 2
        expected = self.curve_of(sheet(PointIds=TEXT, Tau=2))
        self.assertEqual(places(self.curve_of(filter)), places(expected))


class RealMeshes(Case):
    def check(self, mesh, name):
        """The result is smoother, not longer, and on the mesh; the million-face mesh is opened once for two
        values of tau."""
        ids = reference_curve(name)
        filter = pv.TalwegSmoothVertices(Mesh=mesh, PointIds=" ".join(map(str, ids)))
        curve = self.curve_of(filter)
        self.assertEqual(report(curve, "closed"), 1 if ids[0] == ids[-1] else 0)
        self.assertLess(report(curve, "curvature_after"), 0.5 * report(curve, "curvature_before"))
        self.assertLess(report(curve, "length_after"), report(curve, "length_before"))
        self.assertEqual(output(filter, 1).GetNumberOfPolys(), report(curve, "faces"))
        filter.Tau = 8
        closer = self.curve_of(filter)
        self.assertEqual(counts(filter), (1, 1, 2))
        self.assertLessEqual(report(closer, "deviation_to_drawn_mean"),
                             report(curve, "deviation_to_drawn_mean"))

    def test_fandisk(self):
        self.check(pv.PLYReader(FileNames=[str(real_mesh("fandisk_14k.ply"))]), "fandisk_14k")

    def test_tooth(self):
        self.check(pv.PLYReader(FileNames=[str(real_mesh("tooth_ct_119k.ply"))]), "tooth_ct_119k")

    def test_armadillo_loop(self):
        self.check(pv.PLYReader(FileNames=[str(real_mesh("armadillo_86k.ply"))]),
                   "armadillo_86k_loop_large")

    def test_a_mesh_that_is_no_manifold_is_refused_unless_repaired(self):
        mesh = pv.PLYReader(FileNames=[str(real_mesh("car_nonmanifold_251k.ply"))])
        mesh.UpdatePipeline()
        cell = output(mesh, 0).GetCell(1000)
        filter = pv.TalwegSmoothVertices(
            Mesh=mesh, PointIds=f"{cell.GetPointId(0)} {cell.GetPointId(1)}")
        self.assertRegex(self.error_of(filter), "(edge|vertex).* Tick Repair")
        filter.Repair = 1
        curve = self.curve_of(filter)
        self.assertEqual(values(curve, "vertex")[0], cell.GetPointId(0))  # the input's indices


if __name__ == "__main__":
    runner.main()
