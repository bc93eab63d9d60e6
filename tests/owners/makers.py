"""Every program writes a mesh in the formats that it owns.

makers.py MESH FOLDER [PROGRAM...]: any mesh that meshio reads, as for ./run bench --readers.
"""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
SIX_DIGITS = 5e-6  # in parts of the size: the error of coordinates with six digits


class Missing(Exception):
    """Raised for a program that is not installed."""


class File:
    """A file of the mesh, and the ways in which it differs from the mesh."""

    def __init__(self, name, bound=1e-6, y_up=False, weld=False, beside=False):
        self.name = name
        self.bound = bound  # largest distance from the reference, in parts of the mesh's size
        self.y_up = y_up  # (x, y, z) is written as (x, z, -y)
        self.weld = weld  # triangles share no vertices in the file
        self.beside = beside  # the numbers are in a second file, which the page cannot read


def ran(*words, folder=None, **more):
    """Runs a program; a failure becomes an error with its output. :raises Missing: if it is not installed."""
    if shutil.which(words[0]) is None:
        raise Missing(f"there is no {words[0]}")
    done = subprocess.run([str(word) for word in words], cwd=folder, capture_output=True, text=True,
                          check=False, **more)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    return done.stdout


def nibabel(folder, mesh):
    """Files by nibabel: GIFTI in all encodings and orders of arrays, and surfaces of FreeSurfer."""
    try:
        import nibabel as nib
        import nibabel.freesurfer as fs
    except ImportError:
        raise Missing("there is no nibabel (Debian: python3-nibabel)") from None
    vertices, faces = mesh
    gifti, files = nib.gifti, []

    def written(name, bound=1e-6, kind=np.float32, **how):
        about = {"AnatomicalStructurePrimary": "CortexLeft", "GeometricType": "Anatomical"}
        points = gifti.GiftiDataArray(vertices.astype(kind), "NIFTI_INTENT_POINTSET",
                                      meta=gifti.GiftiMetaData(about), **how)
        # A transformation to another space must not move the points.
        points.coordsys = gifti.GiftiCoordSystem(1, 3, np.diag([1.0, 2, 3, 1]))
        corners = gifti.GiftiDataArray(faces.astype(np.int32), "NIFTI_INTENT_TRIANGLE", **how)
        gifti.GiftiImage(darrays=[points, corners]).to_filename(folder / name)
        files.append(File(name, bound))

    written("nibabel-ASCII.L.surf.gii", SIX_DIGITS, encoding="GIFTI_ENCODING_ASCII")
    written("nibabel-B64BIN.L.surf.gii", encoding="GIFTI_ENCODING_B64BIN")
    written("nibabel-B64GZ.L.surf.gii", encoding="GIFTI_ENCODING_B64GZ")
    written("nibabel-columns.L.surf.gii", ordering="ColumnMajorOrder")
    written("nibabel-doubles.L.surf.gii", kind=np.float64, datatype="NIFTI_TYPE_FLOAT64")
    for name in ("lh.white", "lh.pial"):
        fs.write_geometry(folder / name, vertices, faces)
        files.append(File(name))
    return files


def workbench(folder, mesh):
    """GIFTI files in the encodings of wb_command, converted from nibabel's files."""
    nibabel(folder, mesh)
    files = []
    for encoding in ("ASCII", "BASE64_BINARY", "GZIP_BASE64_BINARY"):
        name = f"workbench-{encoding}.L.surf.gii"
        ran("wb_command", "-gifti-convert", encoding, "nibabel-B64GZ.L.surf.gii", name, folder=folder)
        files.append(File(name, SIX_DIGITS if encoding == "ASCII" else 1e-6))
    name = "workbench.L.surf.gii"
    matrix = folder / "identity.txt"
    matrix.write_text("1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
    ran("wb_command", "-surface-apply-affine", "nibabel-B64GZ.L.surf.gii", matrix, name, folder=folder)
    return files + [File(name)]


def gmsh(folder, mesh):
    """Files by gmsh: its formats 2.2 and 4.1, as text and binary, and formats of other programs."""
    write_stl(folder / "for-gmsh.stl", *mesh)
    files = []
    for version in ("msh22", "msh41"):
        for how in ([], ["-bin"]):
            name = f"gmsh-{version}{how[0] if how else ''}.msh"
            ran("gmsh", "for-gmsh.stl", "-save", "-format", version, *how, "-o", name, folder=folder)
            files.append(File(name))
    for ending, how in (("stl", []), ("stl", ["-bin"]), ("vtk", []), ("vtk", ["-bin"])):
        name = f"gmsh{how[0] if how else ''}.{ending}"
        ran("gmsh", "for-gmsh.stl", "-save", "-format", ending, *how, "-o", name, folder=folder)
        files.append(File(name))
    return files


def _polydata(mesh):
    """The mesh as vtkPolyData. :raises Missing: without VTK."""
    try:
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    except ImportError:
        raise Missing("there is no VTK (Debian: python3-paraview or python3-vtk9)") from None
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(mesh[0]))
    for face in mesh[1].tolist():
        cells.InsertNextCell(3, face)
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def vtk(folder, mesh):
    """Files by VTK: legacy files in both encodings and versions, XML files with and without compression."""
    data = _polydata(mesh)
    from vtkmodules.vtkIOGeometry import vtkSTLWriter
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
    from vtkmodules.vtkIOPLY import vtkPLYWriter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    files = []

    def written(writer, name, *settings, bound=1e-6):
        writer.SetInputData(data)
        writer.SetFileName(str(folder / name))
        for setting in settings:
            getattr(writer, setting)()
        if writer.Write() != 1:
            raise AssertionError(f"VTK did not write {name}")
        files.append(File(name, bound))

    for version in (42, 51):
        for kind, bound in (("ASCII", SIX_DIGITS), ("Binary", 1e-6)):
            writer = vtkPolyDataWriter()
            writer.SetFileVersion(version)
            written(writer, f"vtk-{version}-{kind}.vtk", f"SetFileTypeTo{kind}", bound=bound)
    for mode in ("Ascii", "Binary", "Appended"):
        for packed in ("None", "ZLib"):
            written(vtkXMLPolyDataWriter(), f"vtk-{mode}-{packed}.vtp", f"SetDataModeTo{mode}",
                    f"SetCompressorTypeTo{packed}")
    written(vtkXMLPolyDataWriter(), "vtk-raw-big.vtp", "SetDataModeToAppended", "EncodeAppendedDataOff",
            "SetByteOrderToBigEndian", "SetHeaderTypeToUInt32")
    written(vtkPLYWriter(), "vtk-big.ply", "SetFileTypeToBinary", "SetDataByteOrderToBigEndian")
    written(vtkPLYWriter(), "vtk-text.ply", "SetFileTypeToASCII", bound=SIX_DIGITS)
    written(vtkSTLWriter(), "vtk.stl", "SetFileTypeToBinary")
    return files


def meshio(folder, mesh):
    """Files by meshio in all formats that Talweg reads."""
    try:
        import meshio as io
    except ImportError:
        raise Missing("there is no meshio (Debian: python3-meshio)") from None
    whole = io.Mesh(mesh[0], [("triangle", mesh[1].astype(np.int32))])
    files = []
    for name, kind, more in (
            ("meshio.ply", "ply", {"binary": True}), ("meshio-text.ply", "ply", {"binary": False}),
            ("meshio.obj", "obj", {}), ("meshio.off", "off", {}), ("meshio.stl", "stl", {"binary": True}),
            ("meshio-text.stl", "stl", {"binary": False}), ("meshio-42.vtk", "vtk42", {"binary": True}),
            ("meshio-51.vtk", "vtk51", {"binary": True}), ("meshio-22.msh", "gmsh22", {"binary": True}),
            ("meshio-41.msh", "gmsh", {"binary": True}), ("meshio-41-text.msh", "gmsh", {"binary": False})):
        io.write(folder / name, whole, file_format=kind, **more)
        files.append(File(name))
    return files


def blender(folder, mesh):
    """Files by Blender, whose exporters turn the axes unless an option says otherwise."""
    np.savez(folder / "for-blender.npz", vertices=mesh[0], faces=mesh[1])
    ran("blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python",
        HERE / "in_blender.py", "--", folder, env={**os.environ, "HOME": str(folder)})
    up = {"y_up": True}
    return [File("blender.glb", **up), File("blender-separate.gltf", beside=True, **up),
            File("blender-embedded.gltf", **up), File("blender-flat.glb", weld=True, **up),
            File("blender-z-up.glb"), File("blender-y-up.obj", SIX_DIGITS, **up),
            File("blender.obj", SIX_DIGITS), File("blender.ply"), File("blender-text.ply", SIX_DIGITS),
            File("blender.stl"), File("blender-text.stl", SIX_DIGITS)]


def openmesh(folder, mesh):
    """Files by OpenMesh in all its formats; PLY and OFF in both byte orders."""
    program = os.environ.get("TALWEG_OPENMESH_WRITER", "")
    if not program:
        raise Missing("the program that writes by OpenMesh is not built")
    write_off(folder / "for-openmesh.off", *mesh)
    ran(program, folder / "for-openmesh.off", folder)
    names = {"openmesh.om": 1e-6, "openmesh-big.om": 1e-6, "openmesh.ply": 1e-6, "openmesh-big.ply": 1e-6,
             "openmesh.off": 1e-6, "openmesh-text.off": SIX_DIGITS, "openmesh.obj": SIX_DIGITS,
             "openmesh.stl": 1e-6, "openmesh-text.stl": SIX_DIGITS}
    return [File(name, bound) for name, bound in names.items()]


def core_3mf(folder, mesh):
    """A 3MF file after its specification, since none of the installed programs writes 3MF."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>',
             '<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">',
             '<resources><object id="1" type="model"><mesh><vertices>']
    lines += ['<vertex x="%.17g" y="%.17g" z="%.17g"/>' % tuple(p) for p in mesh[0].tolist()]
    lines += ["</vertices><triangles>"]
    lines += ['<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(f) for f in mesh[1].tolist()]
    lines += ['</triangles></mesh></object></resources><build><item objectid="1"/></build></model>']
    kind = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    with zipfile.ZipFile(folder / "specification.3mf", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("_rels/.rels", f'<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/'
                         f'relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="{kind}"/>'
                         "</Relationships>")
        archive.writestr("3D/3dmodel.model", "\n".join(lines))
    return [File("specification.3mf")]


MAKERS = (nibabel, workbench, gmsh, vtk, meshio, blender, openmesh, core_3mf)


def write_stl(path, vertices, faces):
    """A binary STL file."""
    rows = np.zeros(len(faces), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("zero", "<u2")]))
    rows["corners"] = vertices[faces]
    Path(path).write_bytes(b" " * 80 + np.uint32(len(faces)).tobytes() + rows.tobytes())


def write_off(path, vertices, faces):
    """A text OFF file with 17 digits."""
    with open(path, "w", encoding="ascii") as out:
        out.write("OFF\n%d %d 0\n" % (len(vertices), len(faces)))
        for p in vertices.tolist():
            out.write("%.17g %.17g %.17g\n" % tuple(p))
        for f in faces.tolist():
            out.write("3 %d %d %d\n" % tuple(f))


def main():
    import meshio as io
    mesh = io.read(sys.argv[1])
    folder = Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for maker in MAKERS:
        if maker.__name__ in sys.argv[3:] or len(sys.argv) == 3:
            maker(folder, (np.asarray(mesh.points, float), np.asarray(mesh.cells_dict["triangle"])))


if __name__ == "__main__":
    main()
