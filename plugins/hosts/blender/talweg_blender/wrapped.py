"""Sentences in panels."""

import textwrap

import bpy


def draw(layout, lines, width=None, icon="ERROR"):
    """Draws lines as several labels, since a label is cut off at the width of its panel.

    :param width: in letters; None: the width of the region.
    """
    column = layout.column(align=True)
    column.scale_y = 0.8
    for line in lines:
        for number, part in enumerate(textwrap.wrap(line, width or _letters())):
            column.label(text=part, icon="BLANK1" if number else icon)


def _letters():
    """About how many letters fit beside an icon."""
    region = bpy.context.region
    if region is None or region.width < 100:  # a panel that is being created
        return 36
    return max(int((region.width / bpy.context.preferences.system.ui_scale - 75) / 6.2), 16)
