"""Folders of shipped files that are adopted."""
