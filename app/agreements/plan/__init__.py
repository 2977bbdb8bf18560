"""Milestones with their dates, cues and amounts."""
