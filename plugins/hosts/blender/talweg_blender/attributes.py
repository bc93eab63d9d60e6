"""All data of a Blender mesh besides its surface: read before a change, and written to the changed mesh."""

import numpy as np

from . import layers
from .package import talweg

#: For each type of a generic attribute: the member with the values, their number, and their numpy type.
_KINDS = {"FLOAT": ("value", 1, np.float32), "INT": ("value", 1, np.int32),
          "INT8": ("value", 1, np.int32), "BOOLEAN": ("value", 1, bool),
          "FLOAT_VECTOR": ("vector", 3, np.float32), "FLOAT2": ("vector", 2, np.float32),
          "FLOAT_COLOR": ("color", 4, np.float32), "BYTE_COLOR": ("color_srgb", 4, np.float32)}
_EDGE_FLAGS = {"use_seam": bool, "use_edge_sharp": bool, "use_freestyle_mark": bool,
               "crease": np.float32, "bevel_weight": np.float32}
_FACE_FLAGS = {"material_index": np.int32, "use_smooth": bool, "use_freestyle_mark": bool}
_FLAG_ATTRIBUTES = ("position", "material_index", "sharp_face", "sharp_edge")  # handled separately


def read(items, member, columns=1, dtype=np.float32):
    """A member of all items: (n,), or (n, columns) if columns > 1."""
    values = np.empty((len(items), columns) if columns > 1 else len(items), dtype)
    items.foreach_get(member, values.ravel())
    return values


def write(items, member, values):
    items.foreach_set(member, np.ascontiguousarray(values).ravel())


class Attributes:
    """Data of a mesh at vertices, edges, polygons and their corners.

    Talweg interpolates the data of vertices and corners, as attributes of a talweg.Mesh. New edges and
    polygons copy the data of the old element that they are a part of. Data that are 0 everywhere are left
    out.
    """

    def __init__(self, obj, arrays):
        mesh = obj.data
        self.at_corners, self.at_edges, self.at_faces = {}, {}, {}
        self.at_vertices = layers.read(mesh)
        self.made = []  # (name, domain, type) of each generic attribute, in their order
        self.lost = []  # names of data that cannot be kept, for the user
        self.active_colour = mesh.color_attributes.active_color_index
        self._read_generic(mesh)
        self._read_edges(mesh)
        for name, dtype in _FACE_FLAGS.items():
            self.at_faces["flag:" + name] = read(mesh.polygons, name, 1, dtype)
        for face_map in mesh.face_maps:  # stored plus 1, so that 0 is "none"
            self.at_faces["face_map"] = read(face_map.data, "value", 1, np.int32) + 1
        if mesh.has_bevel_weight_vertex:
            self.at_vertices["bevel_weight"] = read(mesh.vertices, "bevel_weight")
        self._read_uv(mesh)
        if mesh.has_custom_normals:
            mesh.calc_normals_split()
            self.at_corners["normals"] = read(mesh.loops, "normal", 3)
        self.groups = [group.name for group in obj.vertex_groups]
        self.active_group = obj.vertex_groups.active_index
        if self.groups:
            self.at_vertices["groups"] = self._weights(mesh)
        self.of_corners = {name: values[arrays.loops] for name, values in self.at_corners.items()}

    def _read_edges(self, mesh):
        self.vertex_count = len(mesh.vertices)
        self.edges = read(mesh.edges, "vertices", 2, np.int32)
        self.loop_edges = read(mesh.loops, "edge_index", 1, np.int32)
        absent = {"crease": not mesh.has_crease_edge, "bevel_weight": not mesh.has_bevel_weight_edge}
        for name, dtype in _EDGE_FLAGS.items():
            values = None if absent.get(name) else read(mesh.edges, name, 1, dtype)
            if values is not None and values.any():
                self.at_edges["flag:" + name] = values

    def _read_uv(self, mesh):
        self.uv_layers = [(uv.name, uv.active, uv.active_render, uv.active_clone)
                          for uv in mesh.uv_layers]
        for uv in mesh.uv_layers:
            self.at_corners["uv:" + uv.name] = read(uv.data, "uv", 2)
            pinned = read(uv.data, "pin_uv", 1, bool)
            if pinned.any():
                self.at_corners["pin:" + uv.name] = pinned

    def _read_generic(self, mesh):
        at = {"POINT": self.at_vertices, "EDGE": self.at_edges, "FACE": self.at_faces,
              "CORNER": self.at_corners}
        for attribute in mesh.attributes:
            if attribute.name.startswith(".select") or attribute.name in _FLAG_ATTRIBUTES:
                continue
            if attribute.data_type not in _KINDS or attribute.domain not in at:
                self.lost.append(f"the {attribute.data_type.lower()} attribute {attribute.name}")
                continue
            member, columns, dtype = _KINDS[attribute.data_type]
            self.made.append((attribute.name, attribute.domain, attribute.data_type))
            at[attribute.domain]["of:" + attribute.name] = read(attribute.data, member, columns, dtype)

    def _weights(self, mesh):
        weights = np.zeros((len(mesh.vertices), len(self.groups)), np.float32)
        for vertex in mesh.vertices:
            for group in vertex.groups:
                if group.group < len(self.groups):
                    weights[vertex.index, group.group] = group.weight
        return weights

    def mesh(self, arrays, **how):
        """A talweg.Mesh with the attributes of vertices and corners."""
        return talweg.Mesh(arrays.vertices, arrays.triangles, vertex_attributes=self.at_vertices,
                           corner_attributes=self.of_corners, **how)

    def write(self, obj, made, layout, vertices, edge_from):
        """Writes the data to the new geometry of the object.

        :param made: the talweg.MadeMesh.
        :param layout: its polygons (polygons.Layout).
        :param vertices: (k,), the vertices of ``made`` that the object has.
        :param edge_from: (edges,), the old edge that each new edge is a part of, or -1.
        """
        mesh = obj.data
        layers.make(mesh, self.at_vertices)
        at = {"POINT": {name: values[vertices] for name, values in made.vertex_attributes.items()},
              "CORNER": {name: _at_loops(values, layout)
                         for name, values in made.corner_attributes.items()},
              "EDGE": _picked(self.at_edges, edge_from),
              "FACE": _picked(self.at_faces, layout.polygon_from)}
        for name, domain, kind in self.made:
            attribute = mesh.attributes.get(name) or mesh.attributes.new(name, kind, domain)
            write(attribute.data, _KINDS[kind][0], at[domain]["of:" + name])
        if 0 <= self.active_colour < len(mesh.color_attributes):
            mesh.color_attributes.active_color_index = self.active_colour
        for name in _EDGE_FLAGS:
            if "flag:" + name in at["EDGE"]:
                write(mesh.edges, name, at["EDGE"]["flag:" + name])
        for name in _FACE_FLAGS:
            write(mesh.polygons, name, at["FACE"]["flag:" + name])
        if "face_map" in at["FACE"]:
            write(mesh.face_maps.new().data, "value", at["FACE"]["face_map"] - 1)
        layers.write(mesh, at["POINT"], (made.origin.weights[vertices] == 0).all(axis=1))
        if "bevel_weight" in at["POINT"]:
            write(mesh.vertices, "bevel_weight", at["POINT"]["bevel_weight"])
        self._write_uv(mesh, at["CORNER"])
        if self.groups:
            self.write_groups(obj, at["POINT"]["groups"])
        if "normals" in at["CORNER"]:
            mesh.normals_split_custom_set(at["CORNER"]["normals"])

    def _write_uv(self, mesh, at_corners):
        for name, active, of_render, of_clone in self.uv_layers:
            layer = mesh.uv_layers.get(name) or mesh.uv_layers.new(name=name, do_init=False)
            write(layer.data, "uv", at_corners["uv:" + name])
            if "pin:" + name in at_corners:
                write(layer.data, "pin_uv", at_corners["pin:" + name])
        for name, active, of_render, of_clone in self.uv_layers:
            layer = mesh.uv_layers[name]
            layer.active_render = layer.active_render or of_render
            layer.active_clone = layer.active_clone or of_clone
            if active:
                mesh.uv_layers.active = layer

    def write_groups(self, obj, weights):
        """Writes the vertex groups. A vertex with the weight 0 is not made a member."""
        for number, name in enumerate(self.groups):
            group = obj.vertex_groups.get(name) or obj.vertex_groups.new(name=name)
            members = np.flatnonzero(weights[:, number] > 0)
            of_members = weights[members, number]
            for weight in np.unique(of_members).tolist():
                group.add(members[of_members == np.float32(weight)].tolist(), weight, "REPLACE")
        if 0 <= self.active_group < len(obj.vertex_groups):
            obj.vertex_groups.active_index = self.active_group


def _picked(attributes, source):
    """Rows of the attributes at the old elements ``source``; 0 where ``source`` is -1."""
    result = {}
    for name, values in attributes.items():
        none = np.zeros((1,) + values.shape[1:], values.dtype)
        result[name] = np.concatenate([values, none])[source]
    return result


def _at_loops(values, layout):
    flat = values.reshape((-1,) + values.shape[2:])[layout.loop_from]
    return np.nan_to_num(flat) if flat.dtype.kind == "f" else flat
