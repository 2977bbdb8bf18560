"""Counts of the takes of each cue, kept with every change."""
