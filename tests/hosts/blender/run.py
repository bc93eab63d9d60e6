"""Inside Blender: installs the add-on from its zip into an empty home, and runs a file of tests."""

import os
import runpy
import shutil
import sys
import unittest
from pathlib import Path

try:
    import numpy  # noqa: F401
except ImportError:
    print("SKIPPED: Blender's Python has no numpy (Debian: python3-numpy)")
    sys.exit(0)

import bpy  # noqa: E402

test = Path(sys.argv[sys.argv.index("--") + 1])
shutil.rmtree(os.environ["BLENDER_USER_RESOURCES"], ignore_errors=True)
os.makedirs(os.environ["BLENDER_USER_RESOURCES"])
bpy.ops.preferences.addon_install(filepath=os.environ["TALWEG_ADDON"])
bpy.ops.preferences.addon_enable(module="talweg_blender")

sys.path[:0] = [str(test.parent.parent / "python"), str(test.parent)]
names = runpy.run_path(str(test))
suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(case)
                           for case in names.values()
                           if isinstance(case, type) and issubclass(case, unittest.TestCase))
outcome = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
assert outcome.testsRun > 0
for why in sorted({why for _, why in outcome.skipped}):
    print("skipped:", why)
bpy.ops.preferences.addon_disable(module="talweg_blender")
sys.exit(0 if outcome.wasSuccessful() else 1)
