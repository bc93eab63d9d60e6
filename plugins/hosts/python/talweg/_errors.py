"""Exceptions: one class for each status of the plugin interface."""

from __future__ import annotations

from typing import Dict, Type


class Error(Exception):
    """Base of Talweg's exceptions; ``str(error)`` is a sentence for the user.

    ``code`` is the status of ``talweg_plugin.h``, e.g. 3 for ``TALWEG_BAD_CURVE``.
    """

    code = 10


class BadUsage(Error, ValueError):
    """An argument or a parameter is wrong, or a call came at the wrong time."""

    code = 1


class BadMesh(Error, ValueError):
    """The mesh is not a surface on which curves can be drawn."""

    code = 2


class BadCurve(Error, ValueError):
    """A curve does not lie on the mesh, or has too few points, or crosses itself where it must not."""

    code = 3


class BadFile(Error, OSError):
    """A file cannot be opened, read or written."""

    code = 4


class Numerical(Error, ArithmeticError):
    """A factorization or solve failed."""

    code = 5


class OutOfMemory(Error, MemoryError):
    """Memory ran out."""

    code = 6


class Cancelled(Error):
    """A progress callback returned False, or ``cancel()`` was called; there is no result."""

    code = 7


class Unsupported(Error, NotImplementedError):
    """The plugin does not have this function, or a program or package that is needed is missing."""

    code = 9


class Internal(Error):
    """The plugin returned a result that the interface forbids, or failed by its own fault."""

    code = 10


class PluginNotFound(Error, ImportError):
    """There is no plugin with this id; the sentence names the searched folders and the refused modules."""

    code = 4


_BY_CODE: Dict[int, Type[Error]] = {
    kind.code: kind
    for kind in (BadUsage, BadMesh, BadCurve, BadFile, Numerical, OutOfMemory, Cancelled,
                 Unsupported, Internal)
}


def error_of(code: int, sentence: str) -> Error:
    """The exception for a status. An unknown status becomes Internal."""
    kind = _BY_CODE.get(code, Internal)
    return kind(sentence or f"The plugin gave the status {code} and no reason.")
