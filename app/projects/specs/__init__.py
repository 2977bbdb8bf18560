"""The delivery spec of a project."""
