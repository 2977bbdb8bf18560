"""Checks game audio against a delivery spec, and renders the game's files from masters."""
