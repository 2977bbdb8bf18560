"""Sounds of other designers that a project opens."""
