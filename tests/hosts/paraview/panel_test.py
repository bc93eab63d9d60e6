"""The panel has a property for each parameter of the plugin, with its default and its place."""

import os
import re
import subprocess
import unittest

import runner
from support import pv

OPTION = re.compile(r"^  --([a-z-]+)(,--no-[a-z-]+\{false\})?(?: (FLOAT|INT|UINT|TEXT)\S*?(?:=(\S+))?)?"
                    r"( \.\.\.)?(?:\s|$)")


def described():
    """As the driver offers them, which it makes from the plugin's description, too:
    [(id, kind, default or None, advanced)]."""
    help = subprocess.run([os.environ["TALWEG_DRIVER"], "run", "talweg.smooth", "--help"],
                          capture_output=True, text=True, check=True).stdout
    options = []
    advanced = False
    for line in help.splitlines():
        advanced = advanced or line.startswith("Advanced")
        found = OPTION.match(line)
        if found and found[1] not in ("curve", "mesh-units", "report", "write-distance"):
            kind = "LIST" if found[5] else found[3] or "FLAG"
            default = found[4] if found[3] else "1" if found[2] else "0"
            options.append((found[1], kind, default, advanced))
    return options


def property_name(option):
    if option == "points":  # a filter has a property Points of its own
        return "DrawnPoints"
    return "".join(word.capitalize() for word in option.split("-"))


class Panel(unittest.TestCase):
    def setUp(self):
        self.filters = [pv.TalwegSmoothPoints(Input=pv.Sphere()),
                        pv.TalwegSmoothVertices(Input=pv.Sphere()),
                        pv.TalwegSmoothCurve(Input=pv.Sphere(), Curve=pv.Line())]

    def test_every_parameter_has_its_property(self):
        options = described()
        self.assertGreater(len(options), 20)
        own = {"Input", "Curve", "CurveIds", "Points", "Closed", "PointIds", "DistanceField",
               "MeshesOpened", "CurvesSet", "Runs"}
        for filter in self.filters:
            properties = set(filter.ListProperties()) - own
            self.assertLessEqual({"Taus", "Slacks", "Finishes"}, properties)
            self.assertEqual(properties, {property_name(option) for option, *_ in options})

    def test_defaults_and_what_is_advanced(self):
        for option, kind, default, advanced in described():
            name = property_name(option)
            for filter in self.filters:
                value = filter.GetPropertyValue(name)
                with self.subTest(property=name):
                    if kind == "LIST":  # a text; not given
                        self.assertIsNone(default)
                        self.assertEqual(value, "")
                    elif default is None:  # not given
                        self.assertIn(value, (-1, "None"))
                    elif kind == "TEXT":
                        self.assertEqual(value, default)
                    else:
                        self.assertEqual(value, float(default))
                    shown = filter.SMProxy.GetProperty(name).GetPanelVisibility()
                    self.assertEqual(shown, "advanced" if advanced else "default")

    def test_documentation(self):
        for filter in self.filters:
            for option, *_ in described():
                doc = filter.SMProxy.GetProperty(property_name(option)).GetDocumentation()
                self.assertGreater(len(doc.GetDescription()), 10)


if __name__ == "__main__":
    runner.main()
