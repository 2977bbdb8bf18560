"""Decisions of the talks before a contract."""
