"""The Python package: the one in this add-on's folder, else an installed one."""

try:
    from . import talweg
except ImportError:
    import talweg  # type: ignore[no-redef]

__all__ = ["talweg"]
