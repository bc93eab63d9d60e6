"""A tool to draw on the mesh with a live result: its values, its thread, and its events."""
