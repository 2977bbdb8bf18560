"""Notices in the app."""
