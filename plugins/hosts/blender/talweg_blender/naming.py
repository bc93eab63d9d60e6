"""Errors that name a curve as the user knows it."""

import re
from contextlib import contextmanager

from .package import talweg


@contextmanager
def named(names):
    """A context whose errors begin with the name of the curve that they are about, if it has a name.

    :param names: of each curve; empty: they have none.
    """
    try:
        yield
    except talweg.Error as error:
        raise type(error)(_with_name(error, names)) from None


def _with_name(error, names):
    text = str(error)
    found = re.match(r"Curve (\d+): ", text)
    if found and int(found[1]) < len(names):
        return f"{names[int(found[1])]}: {text[found.end():]}"
    if len(names) == 1 and isinstance(error, talweg.BadCurve):
        return f"{names[0]}: {text}"
    return text
