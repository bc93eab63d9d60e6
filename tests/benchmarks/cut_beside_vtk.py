"""Cuts a mesh along a closed loop by Talweg and by VTK: times, and the properties of the mesh that each loses.

    PYTHONPATH=plugins/hosts/python TALWEG_PLUGIN_PATH=build/lib/talweg/plugins \\
        /usr/bin/python3 tests/benchmarks/cut_beside_vtk.py MESH CURVE [MESH CURVE]...

CURVE is a closed drawing, which talweg.smooth() makes smooth first; both cut along the result. VTK's
way is vtkSelectPolyData, the distance to the loop with a sign, and vtkClipPolyData at 0.
"""

import resource
import sys

import numpy as np
import talweg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkFiltersCore import vtkClipPolyData
from vtkmodules.vtkFiltersModeling import vtkSelectPolyData
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOPLY import vtkPLYReader

LABELS = 10  # labels are 0, 10, 20, ..., so that interpolated labels can be recognized


def processor_time():
    used = resource.getrusage(resource.RUSAGE_SELF)
    return 1000 * (used.ru_utime + used.ru_stime)


def read(path):
    reader = vtkOBJReader() if path.endswith(".obj") else vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    return lists_of(reader.GetOutput())


def lists_of(polydata):
    faces = vtk_to_numpy(polydata.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(polydata.GetPoints().GetData()).astype(np.float64), faces.astype(np.int64)


def attributes_of(vertices, faces):
    """Values whose right answers are known: bands as labels, unit vectors, numbers of faces."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    bands = LABELS * np.floor(20 * (vertices[:, 2] - low[2]) / (high[2] - low[2])).astype(np.int32)
    out = vertices - (low + high) / 2
    out /= np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-300)
    return ({"label": bands, "normal": out}, {"number": np.arange(len(faces), dtype=np.int32)})


def area(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def border_edges(faces):
    edges = np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
    found, count = np.unique(edges, axis=0, return_counts=True)
    return found[count == 1]


def distances(points, starts, ends):
    """Distances of points to the nearest of some segments."""
    along = ends - starts
    squared = np.maximum((along ** 2).sum(axis=1), 1e-300)
    result = np.empty(len(points))
    for k, point in enumerate(points):
        t = np.clip(((point - starts) * along).sum(axis=1) / squared, 0, 1)
        result[k] = np.sqrt((((starts + t[:, None] * along) - point) ** 2).sum(axis=1).min())
    return result


def by_talweg(given, curve):
    """From arrays, opening included."""
    mesh = talweg.Mesh(given.vertices, given.faces, vertex_attributes=given.vertex_attributes,
                       face_attributes=given.face_attributes, plugin="talweg.cut")
    made = mesh.cut(curve, split=True).meshes
    return [(m.vertices, m.faces, m.vertex_attributes, m.face_attributes) for m in made]


def by_vtk(given, curve):
    """From a vtkPolyData, which is made before the clock runs."""
    loop = vtkPoints()
    loop.SetData(numpy_to_vtk(np.ascontiguousarray(curve.positions)))
    select = vtkSelectPolyData()
    select.SetInputData(given)
    select.SetLoop(loop)
    select.GenerateSelectionScalarsOn()
    select.SetSelectionModeToSmallestRegion()
    clip = vtkClipPolyData()
    clip.SetInputConnection(select.GetOutputPort())
    clip.GenerateClippedOutputOn()
    clip.Update()
    return [_pieces(clip.GetOutput()), _pieces(clip.GetClippedOutput())]


def _pieces(polydata):
    arrays = [{data.GetArrayName(k): vtk_to_numpy(data.GetArray(k))
               for k in range(data.GetNumberOfArrays())}
              for data in (polydata.GetPointData(), polydata.GetCellData())]
    return (*lists_of(polydata), *arrays)


def judged(pieces, ms, vertices, faces, curve):
    """The values of two pieces in a line of the table."""
    whole = area(vertices, faces)
    edge = np.linalg.norm(vertices[faces[:, 0]] - vertices[faces[:, 1]], axis=1).mean()
    smaller = min(pieces, key=lambda piece: area(*piece[:2]))
    border = border_edges(smaller[1])
    ends = smaller[0][border]
    loop = curve.positions
    far = distances(ends.reshape(-1, 3), loop, np.roll(loop, -1, axis=0))
    back = distances(loop, ends[:, 0], ends[:, 1])
    labels = np.concatenate([piece[2]["label"] for piece in pieces])
    normals = np.concatenate([piece[2]["normal"] for piece in pieces])
    off = np.abs(np.linalg.norm(normals, axis=1) - 1)
    return {"ms": ms, "border to curve, edges": far.max() / edge,
            "curve to border, edges": back.max() / edge,
            "shortest edge of the border, edges":
                np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).min() / edge,
            "area lost": 1 - sum(area(*piece[:2]) for piece in pieces) / whole,
            "labels that none had": int(np.count_nonzero(labels % LABELS)),
            "normals not 1 long": int(np.count_nonzero(off > 1e-6)),
            "faces' values kept": all(_kept(piece, vertices, faces) for piece in pieces)}


def _kept(piece, vertices, faces):
    """Whether each face lies within the bounding box of the old face whose number it has."""
    old, new = vertices[faces[piece[3]["number"]]], piece[0][piece[1]]
    slack = 1e-5 * np.abs(vertices).max()
    return bool((new.min(axis=1) >= old.min(axis=1) - slack).all()
                and (new.max(axis=1) <= old.max(axis=1) + slack).all())


def compare(mesh, drawing):
    vertices, faces = read(mesh)
    curve = talweg.smooth((vertices, faces), talweg.read_curves(drawing)[0]).curve
    if not curve.closed:
        sys.exit(f"{drawing} is not a closed curve.")
    print(f"{mesh}: {len(faces)} faces, a loop of {len(curve.positions)} points")
    at_vertices, at_faces = attributes_of(vertices, faces)
    arrays = talweg.Mesh(vertices, faces, vertex_attributes=at_vertices, face_attributes=at_faces)
    for name, cut, given in (("Talweg " + talweg.__version__, by_talweg, arrays),
                             ("VTK " + vtkVersion.GetVTKVersion(), by_vtk, arrays.to_vtk())):
        begin = processor_time()
        pieces = cut(given, curve)
        ms = processor_time() - begin
        told = judged(pieces, ms, vertices, faces, curve)
        print(f"  {name}:", ", ".join(f"{key} {value:.3g}" if isinstance(value, float)
                                      else f"{key} {value}" for key, value in told.items()))
        print("   ", "; ".join(f"piece of {len(piece[1])} faces" for piece in pieces))


def main():
    if len(sys.argv) < 3 or len(sys.argv) % 2 == 0:
        sys.exit(__doc__)
    for mesh, drawing in zip(sys.argv[1::2], sys.argv[2::2]):
        compare(mesh, drawing)


if __name__ == "__main__":
    main()
