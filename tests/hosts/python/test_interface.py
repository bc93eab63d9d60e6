"""The structs of ctypes equal the header's, and the package has the project's version."""

import ctypes
import re
import unittest

import support
import talweg
from talweg import _interface

HEADER = re.sub(r"/\*.*?\*/", "", "".join(
    (support.SOURCE / "plugins/interface" / name).read_text()
    for name in ("talweg_plugin.h", "talweg_curve_files.h", "talweg_way_points.h",
                 "talweg_meshes.h", "talweg_mesh_files.h")), flags=re.DOTALL)

STRUCTS = {"array": "Array", "field": "Field", "mesh": "Mesh", "curve": "Curve",
           "parameter": "Parameter", "output": "Output", "sink": "Sink", "host": "Host",
           "report_entry": "ReportEntry", "host_log": "HostLog", "host_progress": "HostProgress",
           "plugin": "Plugin", "module": "Module", "curve_files": "CurveFiles",
           "curve_files_2": "CurveFiles2", "curve_files_3": "CurveFiles3",
           "way_points": "WayPoints",
           "attribute": "Attribute", "origin": "Origin", "meshes": "Meshes",
           "name_list": "NameList", "mesh_file": "MeshFile", "mesh_files": "MeshFiles"}
SCALARS = {"uint32_t": ctypes.c_uint32, "uint64_t": ctypes.c_uint64, "int64_t": ctypes.c_int64,
           "double": ctypes.c_double, "const char *": ctypes.c_char_p}


def members(struct):
    """(type, name) of each member; functions have the type "function"."""
    body = re.search(r"typedef struct talweg_%s \{(.*?)\} talweg_%s;" % (struct, struct), HEADER,
                     re.DOTALL).group(1)
    result = []
    for declaration in filter(None, (" ".join(d.split()) for d in body.split(";"))):
        function = re.match(r".*?\(\*(\w+)\)\(", declaration)
        if function:
            result.append(("function", function.group(1)))
        else:
            kind, name = re.match(r"(.*?[ *])(\w+)$", declaration).groups()
            result.append((kind.strip(), name))
    return result


class Interface(unittest.TestCase):
    def test_structs(self):
        self.assertEqual(set(re.findall(r"typedef struct talweg_(\w+) \{", HEADER)), set(STRUCTS))
        for struct, mirror in STRUCTS.items():
            fields = getattr(_interface, mirror)._fields_
            declared = members(struct)
            self.assertEqual([name for _, name in declared], [name for name, _ in fields], struct)
            for (kind, name), (_, ours) in zip(declared, fields):
                if kind in SCALARS:
                    self.assertIs(ours, SCALARS[kind], f"{struct}.{name}")
                elif kind == "function":
                    self.assertTrue(issubclass(ours, ctypes._CFuncPtr), f"{struct}.{name}")

    def test_numbers(self):
        declared = dict(re.findall(r"TALWEG_(\w+) = (\d+(?: << \d)?)", HEADER))
        declared.update(re.findall(r"#define TALWEG_(\w+) (\d+)u?\n", HEADER))
        compared = 0
        for name, value in vars(_interface).items():
            if name.isupper() and isinstance(value, int) and not name.startswith("NO_"):
                self.assertEqual(value, eval(declared[name]), name)  # pylint: disable=eval-used
                compared += 1
        self.assertGreater(compared, 25)
        for name in ("HOST_LOG", "HOST_PROGRESS", "CURVE_FILES", "CURVE_FILES_2", "CURVE_FILES_3",
                     "MESHES"):
            self.assertIn('#define TALWEG_%s "%s"' % (name, getattr(_interface, name).decode()),
                          HEADER)

    def test_version(self):
        project = re.search(r"project\(talweg VERSION (\S+)",
                            (support.SOURCE / "CMakeLists.txt").read_text()).group(1)
        self.assertEqual(talweg.__version__, project)
        self.assertEqual(talweg.plugin("talweg.smooth").version, project)

    def test_descriptions(self):
        self.assertLessEqual({"talweg.smooth", "talweg.draw", "talweg.geodesic", "talweg.distance"},
                             set(talweg.plugins()))
        parameters = talweg.plugin("talweg.smooth").parameters
        self.assertEqual(parameters["tau"].default, 1.0)
        self.assertEqual(parameters["tau"].kind, "number")
        self.assertIsNone(parameters["slack"].default)
        self.assertEqual(parameters["slack"].unit, "mesh units")
        self.assertEqual(parameters["potential"].choices, ("corridor", "paper"))
        self.assertEqual(parameters["finish"].default, "fair")
        text = talweg.help_text()
        for name in parameters:
            self.assertIn("\n" + name, text)


if __name__ == "__main__":
    unittest.main()
