"""The panel has a property for each parameter of the plugin, with its default and its place."""

import os
import re
import subprocess
import unittest

import runner
from support import pv, told

OPTION = re.compile(r"^  --([a-z-]+)(,--no-[a-z-]+\{false\})?(?: (FLOAT|INT|UINT|TEXT)\S*?(?:=(\S+))?)?"
                    r"( \.\.\.)?(?:\s|$)")


OF_THE_DRIVER = ("curve", "mesh-units", "report", "map", "repair", "tag", "write-distance",
                 "write-mesh", "write-labels", "write-became", "write-became-triangle", "quiet",
                 "verbose", "help")
# The driver has a single option --repair for these parameters.
REPAIR = ("repair", "repair-weld", "repair-drop", "repair-orient", "repair-split")


def described(plugin="talweg.smooth"):
    """The parameters as options of the driver, which are also made from the plugin's description: [(id, kind,
    default or None, advanced)]."""
    help = subprocess.run([os.environ["TALWEG_DRIVER"], "run", plugin, "--help"],
                          capture_output=True, text=True, check=True).stdout
    options = []
    advanced = False
    for line in help.splitlines():
        advanced = advanced or line.startswith("Advanced")
        found = OPTION.match(line)
        if found and found[1] not in OF_THE_DRIVER:
            kind = "LIST" if found[5] else found[3] or "FLAG"
            default = found[4] if found[3] else "1" if found[2] else "0"
            options.append((found[1], kind, default, advanced))
    options.append(("repair-weld-tolerance", "FLOAT", "0", True))
    return options + [(step, "FLAG", str(int(step != "repair" or plugin == "talweg.repair")),
                       step != "repair") for step in REPAIR]


def property_name(option):
    if option == "points":  # a filter has a property Points of its own
        return "DrawnPoints"
    return "".join(word.capitalize() for word in option.split("-"))


class Panel(unittest.TestCase):
    def setUp(self):
        mesh, curve = pv.Sphere(), pv.Line()
        drawing = {"Curve", "CurveIds"}
        smooth = {"DistanceField", "SlackUsed", "DeviationReached"}
        self.filters = [  # (plugin, filter, properties that are not parameters)
            ("talweg.smooth", pv.TalwegSmoothPoints(Mesh=mesh), smooth | {"Points", "Closed"}),
            ("talweg.smooth", pv.TalwegSmoothVertices(Mesh=mesh), smooth | {"PointIds"}),
            ("talweg.smooth", pv.TalwegSmoothCurve(Mesh=mesh, Curve=curve), smooth | drawing),
            ("talweg.cut", pv.TalwegCut(Mesh=mesh, Curve=curve), drawing),
            ("talweg.offset", pv.TalwegOffset(Mesh=mesh, Curve=curve), drawing),
            ("talweg.labels", pv.TalwegLabelBorders(Mesh=mesh), set()),
            ("talweg.repair", pv.TalwegRepair(Mesh=mesh), set()),
            ("talweg.measure", pv.TalwegMeasure(Mesh=mesh, Curve=curve), drawing | {"Others"})]

    def test_every_parameter_has_its_property(self):
        self.assertGreater(len(described()), 25)
        for plugin, filter, more in self.filters:
            with self.subTest(filter=filter.GetXMLName()):
                own = more | {"Mesh", "Outcome", "MeshesOpened", "CurvesSet", "Runs"}
                properties = set(filter.ListProperties()) - own
                # The filter counts the curves of its third input itself.
                options = [option for option, *_ in described(plugin) if option != "others"]
                self.assertEqual(properties, {property_name(option) for option in options})
                self.assertIn("Repair", properties)

    def test_defaults_and_advanced_properties(self):
        for plugin, filter, _ in self.filters:
            for option, kind, default, advanced in described(plugin):
                if option == "others":
                    continue
                name = property_name(option)
                value = filter.GetPropertyValue(name)
                with self.subTest(plugin=plugin, property=name):
                    if kind == "LIST":  # a text; empty means no value
                        self.assertIsNone(default)
                        self.assertEqual(value, "")
                    elif default is None:  # no value
                        self.assertIn(value, (-1, "None"))
                    elif kind == "TEXT":
                        self.assertEqual(value, default)
                    else:
                        self.assertEqual(value, float(default))
                    shown = filter.SMProxy.GetProperty(name).GetPanelVisibility()
                    self.assertEqual(shown, "advanced" if advanced else "default")

    def test_errors_have_the_names_of_the_panel(self):
        """For each filter, a value beyond the bound of each number: the error must name the panel's
        property."""
        tried = 0
        for plugin, filter, _ in self.filters:
            for option, kind, default, _ in described(plugin):
                name = property_name(option)
                optional = default is None
                if kind not in ("FLOAT", "INT", "UINT") or option == "others":
                    continue
                with self.subTest(filter=filter.GetXMLName(), property=name):
                    before = filter.GetPropertyValue(name)
                    setattr(filter, name, 0 if optional else -7)
                    filter.UpdatePipeline()
                    sentence = told(filter)
                    setattr(filter, name, before)
                    self.assertNotRegex(sentence, r"[a-z]_[a-z]|\([a-z]+\)")
                    if "must be" not in sentence:  # 0 is allowed
                        continue
                    tried += 1
                    label = filter.SMProxy.GetProperty(name).GetXMLLabel()
                    self.assertIn(f"{label} must be", sentence)
        self.assertGreater(tried, 10)

    def test_documentation(self):
        for plugin, filter, _ in self.filters:
            for option, *_ in described(plugin):
                if option == "others":
                    continue
                doc = filter.SMProxy.GetProperty(property_name(option)).GetDocumentation()
                self.assertGreater(len(doc.GetDescription()), 10)


if __name__ == "__main__":
    runner.main()
