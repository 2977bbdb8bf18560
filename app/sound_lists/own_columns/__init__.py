"""Columns of the project's own."""
