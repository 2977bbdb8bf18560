"""What a cue leaves unsaid."""
