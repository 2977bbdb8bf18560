"""Several cues written as one line."""
