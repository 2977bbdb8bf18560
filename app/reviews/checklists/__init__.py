"""Checklists by category."""
