"""One instance of a plugin: calls that return a result or raise an exception."""

from __future__ import annotations

import ctypes
import logging
import weakref
from ctypes import byref, c_void_p, sizeof
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple

from . import _arrays, _curves, _result_checks, _interruptible, _results
from . import _interface as c
from ._curves import Curve
from ._errors import BadUsage, Internal, Unsupported, error_of
from ._plugins import Parameter, Plugin
from ._types import Array, Progress

_log = logging.getLogger("talweg")
_log.addHandler(logging.NullHandler())  # without logging by the program nothing is printed
_LEVELS = {c.LOG_DEBUG: logging.DEBUG, c.LOG_INFO: logging.INFO, c.LOG_WARNING: logging.WARNING,
           c.LOG_ERROR: logging.ERROR}


Lists = Tuple[Array, Array]  # vertices and faces
_GIVEN_UP: List["Instance"] = []  # abandoned instances, kept until the program ends


class _Host:
    """The host's callbacks for an instance: progress and log. It lives as long as the instance."""

    def __init__(self, version: str) -> None:
        self.progress: Optional[Progress] = None
        self.failure: Optional[BaseException] = None  # the exception of the progress callback
        # The callbacks of ctypes must not own this object: a cycle would keep instances alive.
        me = weakref.ref(self)

        def on_progress(_host: int, stage: bytes, fraction: float) -> int:
            host = me()
            if host is None or host.progress is None:
                return 1
            try:
                return 0 if host.progress(stage.decode(), fraction) is False else 1
            except BaseException as error:  # raised again after the call
                host.failure = error
                return 0

        def on_log(_host: int, severity: int, message: bytes) -> None:
            _log.log(_LEVELS.get(severity, logging.INFO), "%s", message.decode(errors="replace"))

        self._progress = c.HostProgress(sizeof(c.HostProgress), c.ProgressFunction(on_progress))
        self._logging = c.HostLog(sizeof(c.HostLog), c.LogFunction(on_log))
        services = {c.HOST_PROGRESS: ctypes.addressof(self._progress),
                    c.HOST_LOG: ctypes.addressof(self._logging)}
        self.struct = c.Host(sizeof(c.Host), c.INTERFACE_MAJOR, c.INTERFACE_MINOR, b"Python",
                             version.encode(), None,
                             c.GetHostExtension(lambda _host, name: services.get(name)))


class _Collector:
    """The receiver of results: copies each part that the plugin passes to the sink."""

    def __init__(self, plugin: str, limits: _result_checks.Limits) -> None:
        self._plugin = plugin
        self._limits = limits
        self.curves: List[Curve] = []
        self.meshes: List[Lists] = []
        self.fields: Dict[str, Array] = {}
        self.entries: Dict[int, Dict[str, Any]] = {}
        self.failure: Optional[BaseException] = None

    def _taken(self, take: Callable[[Any], None]) -> Callable[[Any, Any], int]:
        checked = _result_checks.guarded(self._plugin, take)

        def function(_context: Any, given: Any) -> int:
            if self.failure is not None:
                return c.HOST_FAILED
            try:
                checked(given.contents)
                return c.OK
            except BaseException as error:  # raised again after the run
                self.failure = error
                return c.HOST_FAILED

        return function

    def _curve(self, given: c.Curve) -> None:
        self.curves.append(_result_checks.check_curve(_curves.copied(given), self._limits))

    def _field(self, given: c.Field) -> None:
        name = given.name.decode()
        self.fields[name] = _result_checks.check_field(name, _arrays.copied(given.values), self._limits)

    def _entry(self, given: c.ReportEntry) -> None:
        _result_checks.check_entry(given, max(len(self.curves), self._limits.curves))
        self.entries.setdefault(given.curve, {})[given.key.decode()] = _results.value_of(given)

    def _mesh(self, given: c.Mesh) -> None:
        vertices, faces = _arrays.copied(given.positions), _arrays.copied_indices(given.triangles)
        _result_checks.check_mesh(vertices, faces)
        self.meshes.append((vertices, faces))

    def sink(self, point_fields: bool, vertex_fields: bool, meshes: bool) -> c.Sink:
        field = c.FieldSink(self._taken(self._field)) if vertex_fields else ctypes.cast(0, c.FieldSink)
        return c.Sink(sizeof(c.Sink), c.WANT_POINT_FIELDS if point_fields else 0, None,
                      c.CurveSink(self._taken(self._curve)),
                      field, c.ReportSink(self._taken(self._entry)),
                      c.MeshSink(self._taken(self._mesh)) if meshes else ctypes.cast(0, c.MeshSink))

    def result(self) -> _results.Result:
        count = max([len(self.curves)] + [number + 1 for number in self.entries])
        reports = [_results.report_of(self.entries.get(k, {})) for k in range(count)]
        return _results.Result(self.curves, reports, _results.report_of(self.entries.get(-1, {})),
                               self.fields)


class Instance:
    """Calls on one instance, one at a time; a second call at the same time is refused."""

    def __init__(self, plugin: Plugin, version: str) -> None:
        self.plugin = plugin
        self._host = _Host(version)
        self._handle = c_void_p()
        status = plugin.table.create(byref(self._host.struct), byref(self._handle))
        if status != c.OK:
            raise error_of(status, f"{plugin.id}: an instance could not be made.")
        self._calls: List[object] = []  # the running call first; later ones are about to be refused
        self.limits = _result_checks.Limits()
        self._given_up = False
        # The host's struct must outlive the instance, so the finalizer holds it.
        self._end = weakref.finalize(self, _destroy, plugin.table.destroy, self._handle, self._host)

    def cancel(self) -> None:
        """From any thread: the running call ends soon, with Cancelled."""
        self.plugin.table.cancel(self._handle)

    def set_mesh(self, vertices: Array, faces: Array,
                 progress: Optional[Progress]) -> None:
        mesh = c.Mesh(sizeof(c.Mesh), 0, _arrays.view(vertices), _arrays.view(faces))
        self._long(lambda: self.plugin.table.set_mesh(self._handle, byref(mesh)), progress)
        self.limits = _result_checks.Limits(len(vertices), len(faces))

    def share_mesh(self, other: "Instance") -> None:
        self._short(lambda: self.plugin.table.share_mesh(self._handle, other._handle))
        self.limits = other.limits

    def set_curves(self, curves: Sequence[Curve],
                   progress: Optional[Progress]) -> None:
        pointers, kept = _curves.views(curves)
        self._long(lambda: self.plugin.table.set_curves(self._handle, pointers, len(curves)),
                   progress)
        del kept  # the arrays were needed up to this line
        self.limits = self.limits._replace(curves=len(curves))

    def set(self, parameter: Parameter, value: Any) -> None:
        """Sets a parameter from a Python value; None sets its default, or no value."""
        table, id = self.plugin.table, parameter.id.encode()
        if value is None:
            self._short(lambda: table.reset(self._handle, id))
        elif parameter.kind == "choice":
            choice = _text(parameter, value).encode()
            self._short(lambda: table.set_choice(self._handle, id, choice))
        elif parameter.kind in ("vertices", "field", "per_curve", "triangle_field"):
            array = _arrays.readable(value, 1, f"{parameter.label} ({parameter.id})")
            view = _arrays.view(array)
            self._short(lambda: table.set_array(self._handle, id, byref(view)))
        else:
            number = _number(parameter, value)
            self._short(lambda: table.set_number(self._handle, id, number))

    def run(self, point_fields: bool, vertex_fields: bool,
            progress: Optional[Progress]) -> _results.Result:
        return self._run(point_fields, vertex_fields, False, progress).result()

    def run_with_meshes(self, vertex_fields: bool, progress: Optional[Progress],
                        point_fields: bool = False) -> Tuple[_results.Result, List[Lists]]:
        """The result, and the lists of the made meshes."""
        collector = self._run(point_fields, vertex_fields, True, progress)
        return collector.result(), collector.meshes

    def takes_attributes(self) -> bool:
        """Whether the plugin interpolates attributes for the meshes that it makes, and returns their
        origin."""
        address = self.plugin.table.get_extension(c.MESHES)
        return bool(address) and bool(c.Meshes.from_address(address).takes & c.TAKES_ATTRIBUTES)

    def set_attributes(self, views: Any, count: int) -> None:
        extension = self._meshes()
        self._short(lambda: extension.set_attributes(self._handle, views, count))

    def take_attributes(self, mesh: int, take: Callable[[Any], None]) -> None:
        """Passes each attribute of a mesh of the last run to ``take``."""
        self._take(self._meshes().attributes, mesh, c.AttributeFunction, take)

    def take_origin(self, mesh: int, take: Callable[[Any], None]) -> None:
        self._take(self._meshes().origin, mesh, c.OriginFunction, take)

    def _meshes(self) -> Any:
        address = self.plugin.table.get_extension(c.MESHES)
        if not address:
            raise Unsupported(f"{self.plugin.id} makes no meshes.")
        return c.Meshes.from_address(address)

    def _take(self, ask: Any, mesh: int, kind: Any, take: Callable[[Any], None]) -> None:
        failures: List[BaseException] = []
        checked = _result_checks.guarded(self.plugin.id, take)

        def taken(_context: Any, given: Any) -> int:
            try:
                checked(given.contents)
                return c.OK
            except BaseException as error:  # raised again after the call
                failures.append(error)
                return c.HOST_FAILED

        function = kind(taken)
        try:
            self._short(lambda: ask(self._handle, mesh, function, None))
        except Exception:
            if not failures:
                raise
        if failures:
            raise failures[0]

    def _run(self, point_fields: bool, vertex_fields: bool, meshes: bool,
             progress: Optional[Progress]) -> _Collector:
        collector = _Collector(self.plugin.id, self.limits)
        sink = collector.sink(point_fields, vertex_fields, meshes)
        try:
            self._long(lambda: self.plugin.table.run(self._handle, byref(sink)), progress)
        except Exception:
            if collector.failure is None:
                raise
        if collector.failure is not None:
            raise collector.failure
        return collector

    def _long(self, function: Callable[[], Any],
              progress: Optional[Progress]) -> None:
        def work(progress: Optional[Progress]) -> None:
            self._host.progress, self._host.failure = progress, None
            try:
                self._checked(function)
            except Exception:
                if self._host.failure is not None:
                    raise self._host.failure from None
                raise
            finally:
                self._host.progress = self._host.failure = None

        ends = _interruptible.Ends(self.cancel, self._give_up)
        self._exclusively(lambda: _interruptible.call(work, ends, progress))

    def _give_up(self) -> None:
        """Abandons the instance: its call never ends, so everything that the call uses must be kept."""
        _log.error("The plugin %s did not end when it was cancelled. Its call was abandoned, and goes on in "
                   "the background.", self.plugin.id)
        self._given_up = True
        self._end.detach()
        _GIVEN_UP.append(self)

    def _short(self, function: Callable[[], Any]) -> None:
        self._exclusively(lambda: self._checked(function))

    def _exclusively(self, body: Callable[[], Any]) -> None:
        # No lock: Ctrl-C between its acquisition and the next line would leave it locked for ever.
        if self._given_up:
            raise Internal(f"The last call of the plugin {self.plugin.id} has not ended; make a new mesh or "
                           "workspace.")
        me = object()
        try:
            self._calls.append(me)
            if self._calls[0] is not me:
                raise BadUsage("Another call on this workspace is running; use a workspace for each "
                               "thread.")
            body()
        finally:
            if me in self._calls:
                self._calls.remove(me)

    def _checked(self, function: Callable[[], Any]) -> None:
        status = function()
        if status != c.OK:
            sentence = self.plugin.table.last_error(self._handle) or b""
            raise error_of(status, sentence.decode(errors="replace"))


def _destroy(destroy: Callable[[c_void_p], None], handle: c_void_p, _host: _Host) -> None:
    destroy(handle)


def _text(parameter: Parameter, value: Any) -> str:
    if not isinstance(value, str):
        raise BadUsage(f"{parameter.label} ({parameter.id}) must be one of "
                       f"{', '.join(parameter.choices)}, not {value!r}.")
    return value


def _number(parameter: Parameter, value: Any) -> float:
    if not isinstance(value, str):
        try:
            return float(value)
        except (TypeError, ValueError):
            pass
    kind = {"boolean": "True or False", "integer": "a whole number"}.get(parameter.kind, "a number")
    raise BadUsage(f"{parameter.label} ({parameter.id}) must be {kind}, not {value!r}.")


