"""Mesh files: reads and writes the driver's formats through an extension of the plugin talweg.repair."""

from __future__ import annotations

import ctypes
import logging
import os
from ctypes import POINTER, byref, pointer, sizeof
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _arrays
from . import _interface as c
from ._attributes import Parts
from ._carrying import fill_of, rule_of, values_of
from ._files import Path, checked, extension
from ._types import Array

if TYPE_CHECKING:
    from ._made import Chain

_log = logging.getLogger("talweg")
_MOST_COLUMNS, _MESSAGE_SIZE = 64, 1000


def _extension() -> Any:
    return extension("talweg.repair", c.MESH_FILES, c.MeshFiles, "mesh files")


def read_parts(path: Path) -> Parts:
    """The lists of a file, with its names, references and frame. :raises BadFile: as read_mesh()."""
    parts: List[Parts] = []
    failures: List[BaseException] = []
    left_out: List[str] = []

    def take(_context: Any, file: Any) -> int:
        try:
            parts.append(_parts_of(file.contents, path))
            return c.OK
        except BaseException as error:  # raised again after the call
            failures.append(error)
            return c.HOST_FAILED

    functions = c.MeshFileFunction(take), _collector(left_out)
    try:
        checked(lambda message: _extension().read(os.fsencode(path), *functions, None, message,
                                                  _MESSAGE_SIZE))
    except Exception:
        if failures:
            raise failures[0] from None
        raise
    _tell("%s: not read: %s.", path, left_out)
    return parts[0]


def _text(given: bytes) -> str:
    return given.decode(errors="surrogateescape")  # bytes of the file that are not UTF-8 come back unchanged


def _bytes(text: str) -> bytes:
    return text.encode(errors="surrogateescape")


def _collector(texts: List[str]) -> Any:
    return c.TextFunction(lambda _context, text: texts.append(_text(text)))


def _tell(form: str, path: Path, left_out: Sequence[str]) -> None:
    if left_out:
        _log.warning(form, os.fspath(path), ", ".join(left_out))


def _parts_of(file: Any, path: Path) -> Parts:
    attributes: Dict[int, Dict[str, Array]] = {c.OF_VERTICES: {}, c.OF_TRIANGLES: {},
                                               c.OF_CORNERS: {}}
    for k in range(file.attribute_count):
        one = file.attributes[k].contents
        attributes[one.element][_text(one.name)] = values_of(one)
    names = {}
    for k in range(file.name_list_count):
        one = file.name_lists[k].contents
        names[_text(one.attribute)] = [_text(one.names[n]) for n in range(one.count)]
    if file.polygon_count:
        _log.info("%s: %d faces of more than three corners became triangles.",
                  os.fspath(path), file.polygon_count)
    mesh = file.mesh.contents
    return Parts(_arrays.copied(mesh.positions).reshape(-1, 3),
                 _arrays.copied(mesh.triangles).reshape(-1, 3), attributes[c.OF_VERTICES],
                 attributes[c.OF_TRIANGLES], attributes[c.OF_CORNERS], names,
                 [_text(file.references[k]) for k in range(file.reference_count)],
                 _text(file.frame or b"") if file.size >= sizeof(c.MeshFile) else "")


def write_parts(path: Path, parts: Parts, chains: Sequence[Chain] = ()) -> None:
    """Writes lists, and the edges of the chains. :raises BadFile, BadUsage: as write_mesh()."""
    writer = _Writer(parts, chains)
    left_out: List[str] = list(writer.left_out)
    file, collect = writer.file(), _collector(left_out)
    checked(lambda message: _extension().write(os.fsencode(path), byref(file), collect, None,
                                               message, _MESSAGE_SIZE))
    _tell("%s does not hold: %s.", path, left_out)


class _Writer:
    """The interface's structs of a mesh to be written, and the arrays that they point to."""

    def __init__(self, parts: Parts, chains: Sequence[Chain]) -> None:
        self._kept: List[Any] = []
        self.left_out: List[str] = []
        self._mesh = c.Mesh(size=sizeof(c.Mesh),
                            positions=self._view(parts.vertices, 3, "The mesh's vertices"),
                            triangles=self._view(parts.faces, 3, "The mesh's faces"))
        self._attributes: List[c.Attribute] = []
        for element, attributes in ((c.OF_VERTICES, parts.vertex_attributes),
                                    (c.OF_TRIANGLES, parts.face_attributes),
                                    (c.OF_CORNERS, parts.corner_attributes)):
            for name, values in attributes.items():
                self._add(element, name, np.asarray(values))
        self._names = self._name_lists(parts.face_names)
        lines = [_bytes(line) for line in parts.references]
        self._references = (ctypes.c_char_p * len(lines))(*lines)
        self._frame = _bytes(parts.frame)
        self._edges = self._view(_tagged(np.asarray(parts.faces), chains), 3, "The edges")

    def _view(self, values: Any, columns: int, what: str) -> c.Array:
        array = _arrays.readable(values, columns, what)
        self._kept.append(array)
        return _arrays.view(array)

    def _add(self, element: int, name: str, array: Array) -> None:
        at_corners = element == c.OF_CORNERS
        rows = array.shape[0] * (3 if at_corners else 1)
        flat = array.reshape(rows, int(np.prod(array.shape[2 if at_corners else 1:])))
        columns = flat.shape[1]
        if columns == 0:
            return
        if columns > _MOST_COLUMNS:
            self.left_out.append(f"'{name}', which has {columns} columns")
            return
        if flat.dtype.kind == "b":
            flat = flat.astype(np.uint8)
        if columns == 1:
            flat = flat[:, 0]
        values = self._view(flat, columns, f"The attribute {name}")
        self._attributes.append(c.Attribute(
            size=sizeof(c.Attribute), element=element, name=_bytes(name),
            carry=rule_of(name, array, at_corners), fill=fill_of(name, array), values=values))

    def _name_lists(self, names: Mapping[str, Sequence[str]]) -> List[c.NameList]:
        lists = []
        for attribute, texts in names.items():
            strings = (ctypes.c_char_p * len(texts))(*(_bytes(text) for text in texts))
            lists.append(c.NameList(sizeof(c.NameList), len(texts), _bytes(attribute), strings))
        return lists

    def file(self) -> c.MeshFile:
        """The struct of the file; this object must outlive it."""
        return c.MeshFile(
            size=sizeof(c.MeshFile), mesh=pointer(self._mesh),
            attribute_count=len(self._attributes), attributes=_pointers(self._attributes),
            name_list_count=len(self._names), name_lists=_pointers(self._names),
            reference_count=len(self._references), references=self._references, edges=self._edges,
            frame=self._frame)


def _pointers(structs: Sequence[Any]) -> Optional[Any]:
    if not structs:
        return None
    kind = POINTER(type(structs[0]))
    return (kind * len(structs))(*(pointer(one) for one in structs))


def _tagged(faces: Array, chains: Sequence[Chain]) -> Array:
    """Rows (vertex, vertex, curve): the edges of the chains that the mesh has, in the order of the curves. An
    opened seam has two edges at each place."""
    there = _edges_between(faces, [chain.vertices for chain in chains])
    rows: List[Tuple[int, int, int]] = []
    for curve, chain in enumerate(chains):
        at: Dict[int, List[int]] = {}
        for place, vertex in zip(chain.places.tolist(), chain.vertices.tolist()):
            at.setdefault(place, []).append(vertex)
        for place in range(chain.length if chain.closed else chain.length - 1):
            pairs = [(v, w) for v in at.get(place, [])
                     for w in at.get((place + 1) % chain.length, [])
                     if (min(v, w), max(v, w)) in there]
            pairs.sort(key=lambda pair: there[min(pair), max(pair)])
            rows += [(v, w, curve) for v, w in pairs]
    return np.array(rows, np.uint32).reshape(-1, 3)


def _edges_between(faces: Array, vertices: Sequence[Array]) -> Dict[Tuple[int, int], int]:
    """Edges of the faces between these vertices, as (lower vertex, higher vertex), numbered in the order of
    the faces."""
    if not vertices or faces.size == 0:
        return {}
    marked = np.zeros(int(faces.max()) + 1, bool)
    for some in vertices:
        marked[some] = True
    near = faces[marked[faces].sum(axis=1) > 1].astype(np.int64)
    edges = np.sort(near[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    numbered: Dict[Tuple[int, int], int] = {}
    for v, w in edges[marked[edges].all(axis=1)].tolist():
        numbered.setdefault((v, w), len(numbered))
    return numbered
