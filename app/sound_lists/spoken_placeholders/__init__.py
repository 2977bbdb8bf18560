"""Placeholders that a person records by speaking."""
