"""Sentences in panels."""

import textwrap


def draw(layout, lines, width, icon="ERROR"):
    """Wrapped, since a label is cut off at the width of its panel."""
    column = layout.column(align=True)
    column.scale_y = 0.8
    for line in lines:
        for number, part in enumerate(textwrap.wrap(line, width)):
            column.label(text=part, icon="BLANK1" if number else icon)
