"""The palette, approved as a set."""
