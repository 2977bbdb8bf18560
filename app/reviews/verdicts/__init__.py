"""Verdicts: given, undone, deemed, and applied to the contract."""
