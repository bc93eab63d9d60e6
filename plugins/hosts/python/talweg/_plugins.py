"""Finds and loads plugins, and reads their descriptions."""

from __future__ import annotations

import ctypes
import math
import os
import sys
import sysconfig
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

from . import _interface as c
from ._errors import PluginNotFound

_KINDS = {c.NUMBER: "number", c.INTEGER: "integer", c.BOOLEAN: "boolean", c.CHOICE: "choice",
          c.VERTICES: "vertices", c.FIELD: "field",
          c.PER_CURVE: "per_curve", c.TRIANGLE_FIELD: "triangle_field"}

_ON_WINDOWS = sys.platform == "win32"
_MODULES = "*.dll" if _ON_WINDOWS else "*.so"


@dataclass(frozen=True)
class Parameter:
    """A plugin's description of one of its parameters."""

    id: str
    label: str
    #: "number", "integer", "boolean", "choice", "vertices" (shape (n,)), "field" (one per vertex),
    #: "per_curve" (one per curve), "triangle_field" (one per triangle)
    kind: str
    unit: str  #: "mesh units", "radians", ...; "" for a pure number
    doc: str
    default: Any  #: None for a parameter without a default
    minimum: float
    maximum: float
    soft_minimum: float  #: the range for a slider
    soft_maximum: float
    choices: Tuple[str, ...]
    choice_labels: Tuple[str, ...]
    stage: int  #: work that a change repeats: 1: everything, 2: stages that depend on the curves, 3: the run
    optional: bool
    open_minimum: bool  #: whether the minimum itself is excluded
    logarithmic: bool
    advanced: bool


class Plugin:
    """A loaded plugin: its description, and its functions as ``table``."""

    def __init__(self, table: c.Plugin, path: Path) -> None:
        self.table = table
        self.path = path
        self.id: str = table.id.decode()
        self.label: str = table.label.decode()
        self.version: str = table.version.decode()
        self.doc: str = table.doc.decode()
        self.takes_curves = bool(table.flags & c.TAKES_CURVES)
        self.parameters: Dict[str, Parameter] = {}
        for k in range(table.parameter_count):
            parameter = _described(table.parameters[k].contents)
            self.parameters[parameter.id] = parameter

    def __reduce__(self) -> Tuple[Any, ...]:
        return plugin, (self.id,)  # unpickling looks the plugin up by its id


def _described(p: c.Parameter) -> Parameter:
    optional = bool(p.flags & c.OPTIONAL)
    default: Any = None
    if p.type == c.CHOICE:
        default = p.default_choice.decode()
    elif p.type in (c.NUMBER, c.INTEGER, c.BOOLEAN) and not optional:
        default = {c.NUMBER: float, c.INTEGER: int, c.BOOLEAN: bool}[p.type](p.default_number)
    return Parameter(
        p.id.decode(), p.label.decode(), _KINDS.get(p.type, "unknown"), p.unit.decode(),
        p.doc.decode(), default, p.minimum, p.maximum, p.soft_minimum, p.soft_maximum,
        tuple(p.choices[k].decode() for k in range(p.choice_count)),
        tuple(p.choice_labels[k].decode() for k in range(p.choice_count)), p.stage, optional,
        bool(p.flags & c.OPEN_MINIMUM), bool(p.flags & c.LOGARITHMIC), bool(p.flags & c.ADVANCED))


def folders() -> List[Path]:
    """The folders with plugins, in the order of the search: those of ``TALWEG_PLUGIN_PATH`` (``;`` separates them on
    Windows, ``:`` elsewhere); the one inside this package; ``build/`` of a source checkout; those of an installed
    Talweg (not on Windows)."""
    here = Path(__file__).resolve().parent
    result = [Path(f) for f in os.environ.get("TALWEG_PLUGIN_PATH", "").split(os.pathsep) if f]
    result.append(here / "plugins")
    checkout = Path("/", *here.parts[:-4])
    if (checkout / "plugins" / "interface" / "talweg_plugin.h").is_file():
        result.append(checkout / "build" / "lib" / "talweg" / "plugins")
    if _ON_WINDOWS:  # Windows has no common folder of installed libraries
        return result
    libs = ["lib", "lib64"]
    multiarch = sysconfig.get_config_var("MULTIARCH")
    if multiarch:
        libs.append(f"lib/{multiarch}")
    for prefix in dict.fromkeys([sys.prefix, "/usr/local", "/usr"]):
        result += [Path(prefix) / lib / "talweg" / "plugins" for lib in libs]
    return result


def _objection(module: Any) -> str:
    """Why a module cannot be used; "" for a usable one."""
    if not module:
        return "it does not work with hosts of the plugin interface 1.2"
    m = module.contents
    if m.interface_major != c.INTERFACE_MAJOR or m.needs_minor > c.INTERFACE_MINOR:
        return (f"it needs the plugin interface {m.interface_major}.{m.needs_minor}, "
                f"but this host has {c.INTERFACE_MAJOR}.{c.INTERFACE_MINOR}")
    if m.size < ctypes.sizeof(c.Module):
        return "its module is too small"
    for k in range(m.plugin_count):
        plugin = m.plugins[k]
        if not plugin or plugin.contents.size < ctypes.sizeof(c.Plugin):
            return "it has a plugin that is too small"
        if not all(getattr(plugin.contents, name) for name, _ in c.Plugin._fields_[10:]):
            return "it has a plugin that lacks a function"
    return ""


class _Loader:
    """Loads all plugins once; libraries stay loaded until the program ends."""

    def __init__(self) -> None:
        self.plugins: Dict[str, Plugin] = {}
        self.refused: Dict[str, List[Path]] = {}  # refused modules, by the reason
        self.folders = folders()
        self._libraries: List[ctypes.CDLL] = []
        for folder in self.folders:
            for path in sorted(folder.glob(_MODULES)):
                why = self._load(path)
                if why:
                    self.refused.setdefault(why, []).append(path)

    def _load(self, path: Path) -> str:
        try:
            library = ctypes.CDLL(str(path))  # RTLD_NOW | RTLD_LOCAL
        except OSError as error:
            return str(error)
        try:
            entry = c.Entry((c.ENTRY_SYMBOL, library))
        except AttributeError:
            return f"it has no {c.ENTRY_SYMBOL}"
        module = entry(c.INTERFACE_MAJOR, c.INTERFACE_MINOR)
        why = _objection(module)
        if why:
            return why
        self._libraries.append(library)
        for k in range(module.contents.plugin_count):
            plugin = Plugin(module.contents.plugins[k].contents, path)
            self.plugins.setdefault(plugin.id, plugin)
        return ""


_loader: Optional[_Loader] = None
_loading = threading.Lock()


def _loaded() -> _Loader:
    global _loader
    with _loading:
        if _loader is None:
            _loader = _Loader()
        return _loader


def plugin(id: str) -> Plugin:
    """The plugin with this id, e.g. "talweg.smooth".

    :raises PluginNotFound: if there is none; the sentence has the searched folders, and the refused modules.
    """
    loader = _loaded()
    if id in loader.plugins:
        return loader.plugins[id]
    refused = "".join(f" Refused, since {why}: {', '.join(map(str, paths))}."
                      for why, paths in loader.refused.items())
    looked = ", ".join(map(str, loader.folders))
    raise PluginNotFound(f"There is no plugin {id}.{refused} Looked for in {looked} "
                         "(TALWEG_PLUGIN_PATH names other folders).")


def plugins() -> Dict[str, Plugin]:
    """All plugins that were found, by id."""
    return dict(_loaded().plugins)


def help_text(id: str = "talweg.smooth") -> str:
    """A plugin's description, and a line for each parameter: name, default, range, unit, doc."""
    found = plugin(id)
    lines = [f"{found.id} {found.version}: {found.doc}", ""]
    for p in found.parameters.values():
        extent = ""
        if p.choices:
            extent = " | ".join(p.choices)
        elif p.kind in ("number", "integer"):
            low = f"{'>' if p.open_minimum else '>='} {p.minimum:g}"
            extent = low if math.isinf(p.maximum) else f"{low}, <= {p.maximum:g}"
        about = ", ".join(part for part in (p.kind, extent, p.unit) if part)
        default = "" if p.default is None else f" = {p.default}"
        lines.append(f"{p.id}{default} ({about}): {p.doc}")
    return "\n".join(lines)
