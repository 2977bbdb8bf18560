"""Designers on file."""
