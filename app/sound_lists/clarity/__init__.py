"""Facts that a cue leaves unsaid."""
