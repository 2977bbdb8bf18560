"""Reasons and labels of a studio."""
