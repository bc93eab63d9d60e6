"""Strokes of the annotation tool as drawings. One that is astray does not stop the others."""

import numpy as np

from .drawings import Drawing, key_of
from .package import talweg

_MEND = "set the annotation tool's Placement to Surface and draw again"


def thinned(points, distance):
    """Without the points nearer than this to the one kept before; first and last stay.

    A hand that rests draws hooks smaller than a triangle, and a curve must not touch itself."""
    kept = [0]
    for k in range(1, len(points)):
        if not np.linalg.norm(points[k] - points[kept[-1]]) < distance:  # also where it is no number
            kept.append(k)
    if len(kept) > 1 and kept[-1] != len(points) - 1:
        kept[-1] = len(points) - 1
    return points[kept]


def annotated(context, obj, surface, closed, thin, chosen):
    """The Drawing of the scene's active annotation layer in the object's own space.

    :param thin: points are at least so many mean edges apart.
    :param chosen: numbers of strokes such as "0, 2-4, -1"; empty: all.
    :raises talweg.BadCurve: if there are none on the surface.
    """
    every = _strokes(context)
    to_object = np.array(obj.matrix_world.inverted_safe())
    curves, names, warnings, astray, raw = [], [], [], [], []
    for number in _numbers(chosen, len(every)):
        stroke = every[number]
        points = _points(stroke, to_object)
        raw.append(points)
        points = thinned(points, thin * surface.edge)
        is_closed = closed or stroke.use_cyclic
        distance = surface.farthest(points) if np.isfinite(points).all() else 0.0
        reason = _astray(stroke, points, is_closed, distance, surface)
        if reason:
            astray.append(f"Stroke {number} {reason}")
            continue
        if distance > surface.far:
            warnings.append(f"Stroke {number} was drawn {surface.told(distance)}: if that is not meant, "
                            f"{_MEND}.")
        curves.append(talweg.Curve(positions=points, closed=is_closed))
        names.append(f"Stroke {number}")
    if not curves:
        raise talweg.BadCurve(_listed(astray))
    if astray:
        warnings.insert(0, "Left out: " + _listed(astray))
    return Drawing(curves, key_of("annotation", *raw), names, warnings)


def _strokes(context):
    data = context.scene.grease_pencil
    layer = data.layers.active if data and len(data.layers) else None
    frames = layer.frames if layer else ()
    shown = [f for f in frames if f.frame_number <= context.scene.frame_current]
    frame = max(shown, key=lambda f: f.frame_number, default=None)
    if frame is None or not len(frame.strokes):
        raise talweg.BadCurve("There are no annotations; draw with the annotation tool first.")
    return frame.strokes


def _points(stroke, to_object):
    points = np.empty((len(stroke.points), 3), np.float32)
    stroke.points.foreach_get("co", points.ravel())
    return points @ to_object[:3, :3].T + to_object[:3, 3]


def _astray(stroke, points, closed, distance, surface):
    """Why it cannot be used, or nothing."""
    if stroke.display_mode != "3DSPACE":
        return f"is not on a surface: {_MEND}."
    if len(points) < (3 if closed else 2):
        return f"has {len(points)} points that are apart, too few for a curve."
    if not np.isfinite(points).all():
        return "has a coordinate that is not finite."
    return f"lies {surface.told(distance)}: {_MEND}." if distance > surface.too_far else ""


def _listed(sentences):
    more = f" And {len(sentences) - 3} more." if len(sentences) > 3 else ""
    return " ".join(sentences[:3]) + more


def _numbers(text, count):
    """In their order, each once; "-1" is the last stroke. Raises talweg.BadUsage."""
    found = set()
    for word in text.replace(",", " ").split():
        first, dash, last = word.rpartition("-") if not word.startswith("-") else (word, "", "")
        try:
            low = int(first if dash else word)
            high = int(last) if dash else low
            if high < low:
                raise ValueError
        except ValueError:
            raise talweg.BadUsage(f"Strokes: '{word}' is no number or range of strokes.") from None
        for number in (low, high):
            if not -count <= number < count:
                raise talweg.BadUsage(f"Strokes: there is no stroke {number}; there are {count}, from 0.")
        found.update(range(low, high + 1) if low >= 0 else [low + count])
    return sorted(found) if text.strip() else range(count)
