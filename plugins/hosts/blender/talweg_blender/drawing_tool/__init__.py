"""A tool that draws on the mesh while the result is seen: its values, its thread, and its events."""
