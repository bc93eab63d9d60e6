"""run.py MODULE: runs the tests of a module; exits with 77, and says why, if Python lacks numpy."""

import sys
import unittest

try:
    import numpy  # noqa: F401
except ImportError:
    print(f"SKIPPED: {sys.executable} has no numpy (Debian: python3-numpy)")
    sys.exit(77)

outcome = unittest.main(module=sys.argv[1], argv=sys.argv[:1], exit=False, verbosity=2).result
for why in sorted({why for _, why in outcome.skipped}):
    print("skipped:", why)
if outcome.testsRun == len(outcome.skipped) and outcome.wasSuccessful():
    sys.exit(77)
sys.exit(0 if outcome.wasSuccessful() else 1)
