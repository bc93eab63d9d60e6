"""The plugin interface 1.2 (``talweg_plugin.h``, ``talweg_curve_files.h``, ``talweg_way_points.h``,
``talweg_meshes.h``, ``talweg_mesh_files.h``) as ctypes.

Function pointers of this module release Python's global lock while they run; callbacks acquire it.
``tests/hosts/python/test_interface.py`` compares the members with the header.
"""

from __future__ import annotations

from ctypes import (CFUNCTYPE, POINTER, Structure, c_char_p, c_double, c_int64, c_uint32,
                    c_uint64, c_void_p)

INTERFACE_MAJOR = 1
INTERFACE_MINOR = 2

OK, CANCELLED, HOST_FAILED = 0, 7, 8
FLOAT64, FLOAT32, INT32, UINT32, INT64, UINT64 = 1, 2, 3, 4, 5, 6
INT8, UINT8, INT16, UINT16 = 7, 8, 9, 10
NO_VERTEX = NO_TRIANGLE = NO_ENTRY = 2**32 - 1
NUMBER, INTEGER, BOOLEAN, CHOICE, VERTICES, FIELD, PER_CURVE, TRIANGLE_FIELD = 1, 2, 3, 4, 5, 6, 7, 8
OPTIONAL, OPEN_MINIMUM, LOGARITHMIC, ADVANCED = 1, 2, 4, 8
VALUE_NUMBER, VALUE_INTEGER, VALUE_BOOLEAN, VALUE_TEXT = 1, 2, 3, 4
OUTPUT_CURVES, OUTPUT_POINT_FIELD, OUTPUT_VERTEX_FIELD, OUTPUT_REPORT = 1, 2, 3, 4
OUTPUT_MESH, OUTPUT_TRIANGLE_FIELD = 5, 6
WANT_POINT_FIELDS = 1
TAKES_CURVES = 1
HOST_LOG = b"talweg.log/1"
HOST_PROGRESS = b"talweg.progress/1"
CURVE_FILES = b"talweg.curve_files/1"
CURVE_FILES_2 = b"talweg.curve_files/2"
CURVE_FILES_3 = b"talweg.curve_files/3"
WAY_POINTS = b"talweg.way_points/1"
MESHES = b"talweg.meshes/1"
MESH_FILES = b"talweg.mesh_files/1"
OF_VERTICES, OF_TRIANGLES, OF_CORNERS = 1, 2, 3
CARRY_LINEAR, CARRY_ROUNDED, CARRY_NEAREST, CARRY_DIRECTION = 1, 2, 3, 4
TAKES_ATTRIBUTES, TAKES_ANY_MESH = 1, 2
EXACT = b"exact"
MARK_NONE, MARK_PAINTED, MARK_CONTROL = -1.0, -2.0, -3.0
LOG_DEBUG, LOG_INFO, LOG_WARNING, LOG_ERROR = 1, 2, 3, 4

Status = c_uint32


class Array(Structure):
    _fields_ = [("data", c_void_p), ("rows", c_uint64), ("stride", c_uint64),
                ("columns", c_uint32), ("type", c_uint32)]


class Field(Structure):
    _fields_ = [("size", c_uint32), ("name", c_char_p), ("unit", c_char_p), ("values", Array)]


class Mesh(Structure):
    _fields_ = [("size", c_uint32), ("field_count", c_uint32), ("positions", Array),
                ("triangles", Array), ("fields", POINTER(POINTER(Field)))]


class Curve(Structure):
    _fields_ = [("size", c_uint32), ("closed", c_uint32), ("vertices", Array), ("faces", Array),
                ("barycentrics", Array), ("positions", Array), ("pins", Array),
                ("field_count", c_uint32), ("fields", POINTER(POINTER(Field)))]


class WayPoints(Structure):
    _fields_ = [("size", c_uint32), ("reads_exact", c_uint32)]


class Parameter(Structure):
    _fields_ = [("size", c_uint32), ("type", c_uint32), ("stage", c_uint32), ("flags", c_uint32),
                ("id", c_char_p), ("label", c_char_p), ("unit", c_char_p), ("doc", c_char_p),
                ("default_number", c_double), ("minimum", c_double), ("maximum", c_double),
                ("soft_minimum", c_double), ("soft_maximum", c_double),
                ("default_choice", c_char_p), ("choice_count", c_uint32),
                ("choices", POINTER(c_char_p)), ("choice_labels", POINTER(c_char_p))]


class Output(Structure):
    _fields_ = [("size", c_uint32), ("kind", c_uint32), ("name", c_char_p), ("label", c_char_p),
                ("unit", c_char_p), ("doc", c_char_p)]


class ReportEntry(Structure):
    _fields_ = [("size", c_uint32), ("type", c_uint32), ("curve", c_int64), ("key", c_char_p),
                ("is_list", c_uint32), ("count", c_uint32), ("numbers", POINTER(c_double)),
                ("texts", POINTER(c_char_p))]


CurveSink = CFUNCTYPE(Status, c_void_p, POINTER(Curve))
FieldSink = CFUNCTYPE(Status, c_void_p, POINTER(Field))
ReportSink = CFUNCTYPE(Status, c_void_p, POINTER(ReportEntry))
MeshSink = CFUNCTYPE(Status, c_void_p, POINTER(Mesh))


class Sink(Structure):
    _fields_ = [("size", c_uint32), ("wants", c_uint32), ("context", c_void_p),
                ("curve", CurveSink), ("field", FieldSink), ("report", ReportSink),
                ("mesh", MeshSink)]


GetHostExtension = CFUNCTYPE(c_void_p, c_void_p, c_char_p)


class Host(Structure):
    _fields_ = [("size", c_uint32), ("interface_major", c_uint32), ("interface_minor", c_uint32),
                ("name", c_char_p), ("version", c_char_p), ("context", c_void_p),
                ("get_extension", GetHostExtension)]


LogFunction = CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)
ProgressFunction = CFUNCTYPE(c_uint32, c_void_p, c_char_p, c_double)


class HostLog(Structure):
    _fields_ = [("size", c_uint32), ("log", LogFunction)]


class HostProgress(Structure):
    _fields_ = [("size", c_uint32), ("progress", ProgressFunction)]


class Plugin(Structure):
    _fields_ = [("size", c_uint32), ("flags", c_uint32), ("id", c_char_p), ("label", c_char_p),
                ("version", c_char_p), ("doc", c_char_p), ("parameter_count", c_uint32),
                ("output_count", c_uint32), ("parameters", POINTER(POINTER(Parameter))),
                ("outputs", POINTER(POINTER(Output))),
                ("create", CFUNCTYPE(Status, POINTER(Host), POINTER(c_void_p))),
                ("destroy", CFUNCTYPE(None, c_void_p)),
                ("set_mesh", CFUNCTYPE(Status, c_void_p, POINTER(Mesh))),
                ("share_mesh", CFUNCTYPE(Status, c_void_p, c_void_p)),
                ("set_curves", CFUNCTYPE(Status, c_void_p, POINTER(POINTER(Curve)), c_uint64)),
                ("set_number", CFUNCTYPE(Status, c_void_p, c_char_p, c_double)),
                ("set_choice", CFUNCTYPE(Status, c_void_p, c_char_p, c_char_p)),
                ("set_array", CFUNCTYPE(Status, c_void_p, c_char_p, POINTER(Array))),
                ("reset", CFUNCTYPE(Status, c_void_p, c_char_p)),
                ("run", CFUNCTYPE(Status, c_void_p, POINTER(Sink))),
                ("cancel", CFUNCTYPE(None, c_void_p)),
                ("last_error", CFUNCTYPE(c_char_p, c_void_p)),
                ("get_extension", CFUNCTYPE(c_void_p, c_char_p))]


class CurveFiles(Structure):
    _fields_ = [("size", c_uint32),
                ("write", CFUNCTYPE(Status, c_char_p, POINTER(POINTER(Curve)), c_uint64, c_char_p,
                                    c_uint64)),
                ("read", CFUNCTYPE(Status, c_char_p, POINTER(Sink), c_char_p, c_uint64))]


class CurveFiles2(Structure):
    _fields_ = [("size", c_uint32),
                ("write", CFUNCTYPE(Status, c_char_p, c_char_p, POINTER(POINTER(Curve)), c_uint64,
                                    c_char_p, c_uint64)),
                ("read", CFUNCTYPE(Status, c_char_p, c_char_p, POINTER(Sink), c_char_p, c_uint64))]


class CurveFiles3(Structure):
    _fields_ = [("size", c_uint32),
                ("write", CFUNCTYPE(Status, c_char_p, c_char_p, POINTER(Mesh),
                                    POINTER(POINTER(Curve)), c_uint64, c_char_p, c_uint64)),
                ("read", CFUNCTYPE(Status, c_char_p, c_char_p, POINTER(Mesh), POINTER(Sink),
                                   c_char_p, c_uint64))]


class Attribute(Structure):
    _fields_ = [("size", c_uint32), ("element", c_uint32), ("carry", c_uint32),
                ("reserved", c_uint32), ("name", c_char_p), ("fill", c_double), ("values", Array),
                ("corners", Array)]


class Origin(Structure):
    _fields_ = [("size", c_uint32), ("curve_count", c_uint32), ("vertices", Array),
                ("weights", Array), ("triangles", Array), ("closed", Array), ("lengths", Array),
                ("chains", Array)]


AttributeFunction = CFUNCTYPE(Status, c_void_p, POINTER(Attribute))
OriginFunction = CFUNCTYPE(Status, c_void_p, POINTER(Origin))


class Meshes(Structure):
    _fields_ = [("size", c_uint32), ("takes", c_uint32),
                ("set_attributes", CFUNCTYPE(Status, c_void_p, POINTER(POINTER(Attribute)),
                                             c_uint64)),
                ("attributes", CFUNCTYPE(Status, c_void_p, c_uint64, AttributeFunction, c_void_p)),
                ("origin", CFUNCTYPE(Status, c_void_p, c_uint64, OriginFunction, c_void_p))]


class NameList(Structure):
    _fields_ = [("size", c_uint32), ("count", c_uint32), ("attribute", c_char_p),
                ("names", POINTER(c_char_p))]


class MeshFile(Structure):
    _fields_ = [("size", c_uint32), ("attribute_count", c_uint32), ("mesh", POINTER(Mesh)),
                ("attributes", POINTER(POINTER(Attribute))), ("name_list_count", c_uint32),
                ("reference_count", c_uint32), ("name_lists", POINTER(POINTER(NameList))),
                ("references", POINTER(c_char_p)), ("polygon_count", c_uint64), ("edges", Array),
                ("frame", c_char_p)]


MeshFileFunction = CFUNCTYPE(Status, c_void_p, POINTER(MeshFile))
TextFunction = CFUNCTYPE(None, c_void_p, c_char_p)


class MeshFiles(Structure):
    _fields_ = [("size", c_uint32), ("reserved", c_uint32),
                ("read", CFUNCTYPE(Status, c_char_p, MeshFileFunction, TextFunction, c_void_p,
                                   c_char_p, c_uint64)),
                ("write", CFUNCTYPE(Status, c_char_p, POINTER(MeshFile), TextFunction, c_void_p,
                                    c_char_p, c_uint64))]


class Module(Structure):
    _fields_ = [("size", c_uint32), ("interface_major", c_uint32), ("interface_minor", c_uint32),
                ("needs_minor", c_uint32), ("plugin_count", c_uint64),
                ("plugins", POINTER(POINTER(Plugin)))]


Entry = CFUNCTYPE(POINTER(Module), c_uint32, c_uint32)
ENTRY_SYMBOL = "talweg_plugin_entry"
