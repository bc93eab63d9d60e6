"""Drawings of annotations, curve objects and grease pencil. A stroke away from the mesh does not stop the
others."""

from typing import NamedTuple

import numpy as np

from .drawings import Drawing, key_of
from .package import talweg

MEND = "set the annotation tool's Placement to Surface and draw again"


class Item(NamedTuple):
    """A stroke or spline that may become a curve."""

    name: str
    points: np.ndarray  # (n, 3), in the space of the mesh object
    cyclic: bool = False
    exact: bool = False  # its points are way-points, set one by one
    reason: str = ""  # why the item does not lie on a surface; empty: it may lie on one


def annotations(context, obj):
    """The strokes of the scene's active annotation layer.

    :raises talweg.BadCurve: if there are none.
    """
    data = context.scene.grease_pencil
    layer = data.layers.active if data and len(data.layers) else None
    strokes = _shown(layer, context.scene)
    if not strokes:
        raise talweg.BadCurve("There are no annotations; draw with the annotation tool first.")
    to_object = np.array(obj.matrix_world.inverted_safe())
    return [Item(f"Stroke {number}", _points(stroke.points, to_object), stroke.use_cyclic,
                 reason="" if stroke.display_mode == "3DSPACE" else f"is not on a surface: {MEND}.")
            for number, stroke in enumerate(strokes)]


def objects(context, obj):
    """Splines of the selected curve objects and strokes of the selected grease pencil objects. Points of
    Bezier splines are way-points.

    :raises talweg.BadCurve: if there are none.
    """
    found = []
    for one in context.selected_objects:
        move = np.array(obj.matrix_world.inverted_safe()) @ np.array(one.matrix_world)
        if one.type == "CURVE":
            found += [_spline(f"{one.name}, spline {number}" if len(one.data.splines) > 1 else one.name,
                              spline, move) for number, spline in enumerate(one.data.splines)]
        elif one.type == "GPENCIL":
            strokes = [stroke for layer in one.data.layers if not layer.hide
                       for stroke in _shown(layer, context.scene)]
            found += [Item(f"{one.name}, stroke {number}", _points(stroke.points, move), stroke.use_cyclic)
                      for number, stroke in enumerate(strokes)]
    if not found:
        raise talweg.BadCurve("No curve or grease pencil object with something drawn is selected; select "
                              "some, then the mesh (Shift-click).")
    return found


def drawing_of(items, surface, chosen):
    """The Drawing of items on a surface.

    :param chosen: numbers of items such as "0, 2-4, -1"; empty: all.
    :raises talweg.BadCurve: if no item is on the surface.
    """
    curves, names, warnings, astray, raw = [], [], [], [], []
    for number in _numbers(chosen, len(items)):
        item = items[number]
        raw.append(item.points)
        points = item.points
        distance = surface.farthest(points) if np.isfinite(points).all() else 0.0
        reason = item.reason or _astray(points, item.cyclic, distance, surface)
        if reason:
            astray.append(f"{item.name} {reason}")
            continue
        if distance > surface.far:
            warnings.append(f"{item.name} was drawn {surface.distance_text(distance)}: if that is not meant, "
                            f"{MEND}.")
        curves.append(talweg.Curve(positions=points, closed=item.cyclic, exact=item.exact or None))
        names.append(item.name)
    if not curves:
        raise talweg.BadCurve(_listed(astray))
    if astray:
        warnings.insert(0, "Left out: " + _listed(astray))
    return Drawing(curves, key_of("annotation", *raw), names, warnings)


def _shown(layer, scene):
    """The strokes of the layer's frame that is shown."""
    frames = [f for f in (layer.frames if layer else ()) if f.frame_number <= scene.frame_current]
    frame = max(frames, key=lambda f: f.frame_number, default=None)
    return list(frame.strokes) if frame is not None else []


def _points(points, move):
    values = np.empty((len(points), 3), np.float32)
    points.foreach_get("co", values.ravel())
    return values @ move[:3, :3].T + move[:3, 3]


def _spline(name, spline, move):
    is_bezier = spline.type == "BEZIER"
    points = [tuple(point.co)[:3] for point in (spline.bezier_points if is_bezier else spline.points)]
    values = np.array(points, float).reshape(-1, 3) @ move[:3, :3].T + move[:3, 3]
    reason = ("is a NURBS curve; convert it to a polygon first (Set Spline Type > Poly)."
              if spline.type == "NURBS" else "")
    return Item(name, values, spline.use_cyclic_u, is_bezier, reason)


def _astray(points, closed, distance, surface):
    """Why the item cannot become a curve; empty if it can."""
    if len(points) < (3 if closed else 2):
        counted = "1 point" if len(points) == 1 else f"{len(points)} points"
        return f"has {counted} apart from each other, too few for a curve."
    if not np.isfinite(points).all():
        return "has a coordinate that is not finite."
    return f"lies {surface.distance_text(distance)}: {MEND}." if distance > surface.too_far else ""


def _listed(sentences):
    more = f" And {len(sentences) - 3} more." if len(sentences) > 3 else ""
    return " ".join(sentences[:3]) + more


def _numbers(text, count):
    """The chosen numbers, ascending and without repetitions; "-1" is the last stroke. Raises
    talweg.BadUsage."""
    found = set()
    for word in text.replace(",", " ").split():
        first, dash, last = word.rpartition("-") if not word.startswith("-") else (word, "", "")
        try:
            low = int(first if dash else word)
            high = int(last) if dash else low
            if high < low:
                raise ValueError
        except ValueError:
            raise talweg.BadUsage(f"Strokes: '{word}' is not a number or range of strokes.") from None
        for number in (low, high):
            if not -count <= number < count:
                raise talweg.BadUsage(f"Strokes: there is no stroke {number}; there are {count}, from 0.")
        found.update(range(low, high + 1) if low >= 0 else [low + count])
    return sorted(found) if text.strip() else range(count)
