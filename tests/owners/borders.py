"""borders.py FOLDER: labels of a cortex and their borders, written by nibabel and connectome-workbench, read
by the driver and by Python; and the driver's files, read by these programs."""

import json
import sys
from pathlib import Path

import numpy as np

import makers
import shape
from same_curve import curves_of, distance, driver

NAMES = ["???", "V1", "V2", 'motor & "s"']
COLORS = [(0.2, 0, 0.2, 0), (1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1)]  # black means no label in an .annot


def write_inputs(folder):
    """Writes a cortex, the same inflated, and its labels in each format. :raises Missing: without nibabel."""
    try:
        import nibabel as nib
        import nibabel.freesurfer as fs
    except ImportError:
        raise makers.Missing("there is no nibabel (Debian: python3-nibabel)") from None
    gifti, (vertices, faces), labels = nib.gifti, shape.mesh(), shape.labels()
    about = gifti.GiftiMetaData({"AnatomicalStructurePrimary": "CortexLeft"})
    inflated = vertices / np.linalg.norm(vertices, axis=1)[:, None] * 50
    for name, points in (("white", vertices), ("inflated", inflated)):
        fs.write_geometry(folder / f"lh.{name}", points, faces)
        gifti.GiftiImage(darrays=[
            gifti.GiftiDataArray(points.astype(np.float32), "NIFTI_INTENT_POINTSET", meta=about),
            gifti.GiftiDataArray(faces.astype(np.int32), "NIFTI_INTENT_TRIANGLE")
        ]).to_filename(folder / f"lh.{name}.surf.gii")
    table = gifti.GiftiLabelTable()
    for key, (name, color) in enumerate(zip(NAMES, COLORS)):
        table.labels.append(gifti.GiftiLabel(key, *color))
        table.labels[-1].label = name
    gifti.GiftiImage(darrays=[gifti.GiftiDataArray(labels.astype(np.int32), "NIFTI_INTENT_LABEL")],
                     labeltable=table, meta=about).to_filename(folder / "lh.label.gii")
    fs.write_annot(folder / "lh.areas.annot", labels, np.rint(np.array(COLORS) * 255).astype(int), NAMES,
                   fill_ctab=True)
    np.savetxt(folder / "labels.txt", labels)


def check_labels(folder):
    """Each file of labels gives the same borders; nibabel reads the new labels."""
    import nibabel as nib
    import nibabel.freesurfer as fs
    files = ("labels.txt", "lh.label.gii", "lh.areas.annot")
    for k, name in enumerate(files):
        driver("labels", folder / "lh.white", folder / name, "-o", folder / f"borders-{k}.json")
    made = [(folder / f"borders-{k}.json").read_bytes() for k in range(len(files))]
    assert made[0] == made[1] == made[2]
    driver("labels", folder / "lh.white", folder / "lh.label.gii", "-o", folder / "lh.smooth.border",
           "--labels-out", folder / "new.label.gii", "--slack", 0.5)
    driver("labels", folder / "lh.white", folder / "lh.areas.annot", "--labels-out", folder / "new.annot",
           "--slack", 0.5)
    image = nib.load(folder / "new.label.gii")
    values = image.darrays[0].data
    table = image.labeltable.get_labels_as_dict()
    assert [table[k] for k in range(len(NAMES))] == NAMES
    assert np.allclose([label.rgba for label in image.labeltable.labels], COLORS)
    theirs, colors, names = fs.read_annot(folder / "new.annot")
    assert [name.decode() for name in names] == NAMES
    assert np.array_equal(colors[:, :3], np.rint(np.array(COLORS)[:, :3] * 255))
    assert np.array_equal(values, theirs)
    changed = np.count_nonzero(values != shape.labels())
    assert 0 < changed < len(values) / 20, changed


def lengths_by_workbench(folder, border, surface):
    """The lengths by the borders' names; several parts of a border are summed."""
    told = makers.ran("wb_command", "-border-length", border, surface, folder=folder)
    return dict(line.rsplit(": ", 1) for line in told.strip().splitlines())


def length(folder, border, surface):
    """The length of all curves of a file, by the driver."""
    driver("measure", folder / surface, folder / border, "--report", folder / "measured.json")
    return json.loads((folder / "measured.json").read_text(encoding="utf-8"))["length"]


def check_borders(folder):
    """The driver's borders have the same lengths in workbench, on the surface and on the inflated one."""
    for surface in ("lh.white", "lh.inflated"):
        theirs = lengths_by_workbench(folder, "lh.smooth.border", f"{surface}.surf.gii")
        ours = length(folder, "lh.smooth.border", surface)
        told = sum(map(float, theirs.values()))
        assert abs(told - ours) < 2e-5 * ours, (surface, told, ours)
    assert set(theirs) == {"0_1", "0_2", "1_2", "1_3", "2_3"}, theirs
    about = makers.ran("wb_command", "-file-information", "lh.smooth.border", folder=folder)
    assert "CortexLeft" in about, about


def positions_of(path, vertices):
    """Positions of each part of a border file, by its vertices and weights."""
    import xml.etree.ElementTree as xml
    parts = []
    for part in xml.parse(path).iter("BorderPart"):
        corners = np.array(part.findtext("Vertices").split(), int).reshape(-1, 3)
        weights = np.array(part.findtext("Weights").split(), float).reshape(-1, 3)
        weights /= weights.sum(axis=1)[:, None]
        parts.append((np.einsum("ij,ijk->ik", weights, vertices[corners]), part.get("Closed") == "True"))
    return parts


def check_theirs(folder):
    """A border of workbench becomes the drawing through its positions."""
    import talweg
    makers.ran("wb_command", "-label-to-border", "lh.white.surf.gii", "lh.label.gii", "lh.theirs.border",
               folder=folder)
    drawn = positions_of(folder / "lh.theirs.border", shape.mesh()[0])
    shape.write_drawing(folder / "theirs.obj", drawn)
    for name, curve in (("by-border", "lh.theirs.border"), ("by-positions", "theirs.obj")):
        driver("smooth", folder / "lh.white", "--curve", folder / curve, "-o", folder / f"{name}.json")
    ours, expected = (curves_of(folder / f"{name}.json") for name in ("by-border", "by-positions"))
    mesh = talweg.read_mesh(folder / "lh.white")
    result = mesh.smooth(talweg.read_curves(folder / "lh.theirs.border", mesh=mesh))
    in_python = [(curve.positions, curve.closed) for curve in result.curves]
    assert len(ours) == len(expected) == len(in_python) == 3
    for some in (ours, in_python):
        apart = max(map(distance, some, expected)) / shape.SIZE
        assert apart < 1e-6, apart
    talweg.write_curves(folder / "lh.python.border", result.curves, mesh=mesh)
    driver("smooth", folder / "lh.white", "--curve", folder / "lh.theirs.border", "-o",
           folder / "lh.driver.border")
    assert (folder / "lh.python.border").read_bytes() == (folder / "lh.driver.border").read_bytes()


def main():
    folder = Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    try:
        write_inputs(folder)
        check_labels(folder)
        check_borders(folder)
        check_theirs(folder)
    except makers.Missing as missing:
        print(f"skipped: {missing}")


if __name__ == "__main__":
    main()
