"""Estimates against what happened."""
