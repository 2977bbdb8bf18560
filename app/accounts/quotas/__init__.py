"""Limits of what a studio may store."""
