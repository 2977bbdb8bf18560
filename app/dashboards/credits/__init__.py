"""The credits of a project."""
