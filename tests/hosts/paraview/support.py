"""Helpers of the filter's tests: the plugin, meshes, outputs as lists, and ParaView's messages."""

import math
import os
import pathlib
import unittest

from paraview import servermanager
from paraview import simple as pv
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

pv.LoadPlugin(os.environ["TALWEG_PARAVIEW"], remote=False, ns=vars(pv))

MESHES = pathlib.Path(
    os.environ.get("TALWEG_MESHES", pathlib.Path(__file__).parents[4] / "shared" / "meshes"))


def real_mesh(name):
    """The file of a real mesh; skips the test if it is missing."""
    file = MESHES / name
    if not file.exists():
        raise unittest.SkipTest(f"no {name} in {MESHES} (set TALWEG_MESHES)")
    return file


def reference_curve(name):
    """Vertex indices of a reference drawing; a closed drawing repeats its first vertex."""
    file = MESHES.parent / "reference" / "curves" / f"{name}.txt"
    if not file.exists():
        raise unittest.SkipTest(f"no {file.name} in {file.parent} (set TALWEG_MESHES)")
    return [int(word) for word in file.read_text().split()]


def wavy_sheet(n):
    """n x n vertices of a bent sheet in [0, 1]^2: points, triangles; vertex n * row + column."""
    points = []
    for row in range(n):
        for column in range(n):
            x, y = column / (n - 1), row / (n - 1)
            points.append((x, y, 0.1 * math.sin(7 * x) * math.cos(5 * y)))
    triangles = []
    for row in range(n - 1):
        for column in range(n - 1):
            a = n * row + column
            triangles += [(a, a + 1, a + n + 1), (a, a + n + 1, a + n)]
    return points, triangles


def polydata(points, polygons=(), lines=(), precision="double"):
    data = vtkPolyData()
    places = vtkPoints()
    places.SetDataType(11 if precision == "double" else 10)  # VTK_DOUBLE, VTK_FLOAT
    for point in points:
        places.InsertNextPoint(point)
    data.SetPoints(places)
    for cells, give in ((polygons, data.SetPolys), (lines, data.SetLines)):
        array = vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell), cell)
        give(array)
    return data


def source(data):
    """A pipeline object with this data set as output."""
    producer = pv.TrivialProducer()
    producer.GetClientSideObject().SetOutput(data)
    return producer


def output(filter, port):
    return servermanager.Fetch(filter, idx=port)


def values(data, name):
    """A point array as a list of numbers, or of tuples."""
    return rows_of(data.GetPointData().GetArray(name))


def cell_values(data, name):
    """A cell array, likewise."""
    return rows_of(data.GetCellData().GetArray(name))


def rows_of(array):
    rows = [array.GetTuple(k) for k in range(array.GetNumberOfTuples())]
    return [row[0] for row in rows] if array.GetNumberOfComponents() == 1 else rows


def report(data, key):
    """An entry of the report in a data set's field data."""
    array = data.GetFieldData().GetAbstractArray(key)
    get = array.GetValue if array.GetClassName() == "vtkStringArray" else array.GetTuple1
    entries = [get(k) for k in range(array.GetNumberOfTuples())]
    return entries[0] if len(entries) == 1 else entries


def column(table, name):
    """A column of a table with numbers or texts."""
    return [table.GetValueByName(row, name).ToString() if name == "# curve" else
            table.GetValueByName(row, name).ToDouble() for row in range(table.GetNumberOfRows())]


def places(data):
    return [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]


def lines_of(data):
    """The point numbers of each line."""
    lines = []
    for k in range(data.GetNumberOfLines()):
        cell = data.GetCell(data.GetNumberOfVerts() + k)
        lines.append([cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())])
    return lines


def counts(filter):
    """The numbers of opened meshes, of set curves, and of smoothings."""
    filter.SMProxy.UpdatePropertyInformation()
    return tuple(filter.SMProxy.GetProperty(name).GetElement(0)
                 for name in ("MeshesOpened", "CurvesSet", "Runs"))


def told(filter, name="Outcome"):
    """The filter's text on its last run, as in the panel."""
    filter.SMProxy.UpdatePropertyInformation()
    return filter.SMProxy.GetProperty(name).GetElement(0)


class Said:
    """Records messages to ParaView's output window, as (event, text)."""

    def __enter__(self):
        self.lines = []
        self.window = vtkOutputWindow.GetInstance()
        self.tags = []
        for event in ("ErrorEvent", "WarningEvent", "MessageEvent"):
            def listen(_, name, text):
                self.lines.append((name, text))
            listen.CallDataType = "string0"
            self.tags.append(self.window.AddObserver(event, listen))
        return self

    def __exit__(self, *_):
        for tag in self.tags:
            self.window.RemoveObserver(tag)

    def text(self):
        return "".join(text for _, text in self.lines)


class Case(unittest.TestCase):
    def error_of(self, filter):
        """Updates the filter, which must fail with empty outputs; returns the sentence of ParaView's
        error."""
        with Said() as said:
            filter.UpdatePipeline()
        errors = [text for event, text in said.lines if event == "ErrorEvent"]
        self.assertEqual(len(errors), 1, errors)
        self.assertIn("vtkTalweg", errors[0])
        for port in range(filter.SMProxy.GetNumberOfOutputPorts()):
            data = output(filter, port)
            rows = data.GetNumberOfRows() if data.IsA("vtkTable") else data.GetNumberOfPoints()
            self.assertEqual(rows, 0)
        return errors[0]

    def update(self, filter):
        """Updates the filter, which must not fail; returns its warnings."""
        with Said() as said:
            filter.UpdatePipeline()
        self.assertEqual([text for event, text in said.lines if event == "ErrorEvent"], [])
        return [text for event, text in said.lines if event == "WarningEvent"]

    def curve_of(self, filter):
        """Updates the filter, which must not fail; returns its curves."""
        with Said() as said:
            filter.UpdatePipeline()
        self.assertEqual([text for event, text in said.lines if event == "ErrorEvent"], [])
        curves = output(filter, 0)
        self.assertGreater(curves.GetNumberOfPoints(), 1)
        return curves
