"""People whom cues name."""
