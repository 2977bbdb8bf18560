"""Contracts as Word files, written and read again."""
