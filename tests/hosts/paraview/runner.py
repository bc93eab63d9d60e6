"""Runs the tests of the calling file, and prints which were skipped and why."""

import sys
import unittest


def main():
    outcome = unittest.main(exit=False).result
    for why in sorted({why for _, why in outcome.skipped}):
        print("skipped:", why)
    sys.exit(0 if outcome.wasSuccessful() else 1)
