"""Categories of cues."""
