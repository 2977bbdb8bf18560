"""Files that wait for their cue."""
