"""Layers of vertices that Blender makes only through bmesh: shape keys, creases, masks, skin."""

import bmesh
import numpy as np

#: For each layer: the mesh's collection, the layer's name in bmesh, and the members of an item.
_LAYERS = (("vertex_creases", "crease", (("value", 1, np.float32),)),
           ("vertex_paint_masks", "paint_mask", (("value", 1, np.float32),)),
           ("skin_vertices", "skin", (("radius", 2, np.float32), ("use_root", 1, bool),
                                      ("use_loose", 1, bool))))


def _values(items, member, columns, dtype):
    result = np.empty((len(items), columns) if columns > 1 else len(items), dtype)
    items.foreach_get(member, result.ravel())
    return result


def read(mesh):
    """The layers as arrays by name. Shape keys are named by numbers: the library interpolates an attribute
    whose name has "label" like a label, and a user may have named a key so."""
    result = {}
    if mesh.shape_keys is not None:
        for number, key in enumerate(mesh.shape_keys.key_blocks):
            result[f"key:{number}"] = _values(key.data, "co", 3, np.float32)
    for collection, _, members in _LAYERS:
        for layer in getattr(mesh, collection):
            for member, columns, dtype in members:
                result[f"{collection}:{member}"] = _values(layer.data, member, columns, dtype)
    return result


def make(mesh, names):
    """Makes the layers of these names on a mesh with new vertices. Shape keys stay with the mesh, with their
    values, drivers and animation; a pass through bmesh gives them the new number of vertices."""
    wanted = [layer for collection, layer, _ in _LAYERS
              if any(name.startswith(collection + ":") for name in names)]
    if not wanted and mesh.shape_keys is None:
        return
    bm = bmesh.new()
    try:
        bm.from_mesh(mesh, use_shape_key=False)
        for layer in wanted:
            getattr(bm.verts.layers, layer).verify()
        bm.to_mesh(mesh)
    finally:
        bm.free()


def write(mesh, at_vertices, from_nowhere):
    """Writes the values of the layers.

    :param from_nowhere: (n,), vertices inside lids; a shape key has them at their place in the mesh.
    """
    if mesh.shape_keys is not None:
        places = _values(mesh.vertices, "co", 3, np.float32)
        for number, key in enumerate(mesh.shape_keys.key_blocks):
            values = np.where(from_nowhere[:, None], places, at_vertices[f"key:{number}"])
            key.data.foreach_set("co", values.astype(np.float32).ravel())
    for collection, _, members in _LAYERS:
        for layer in getattr(mesh, collection):
            for member, _, dtype in members:
                values = at_vertices.get(f"{collection}:{member}")
                if values is not None:
                    layer.data.foreach_set(member, np.ascontiguousarray(values, dtype).ravel())
