"""People that cues name."""
