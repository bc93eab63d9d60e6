"""The Python package: the copy in the add-on's folder, else an installed one."""

try:
    from . import talweg
except ImportError:
    import talweg  # type: ignore[no-redef]

__all__ = ["talweg"]
