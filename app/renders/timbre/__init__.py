"""The timbre of sounds, for comparison."""
