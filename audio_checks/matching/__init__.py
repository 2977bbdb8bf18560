"""Finds the cue that a file is for by its name, however it is spelt."""
