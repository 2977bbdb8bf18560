"""The progress of cues."""
