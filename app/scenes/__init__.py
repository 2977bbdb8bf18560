"""Sounds in their scene: beds, neighbours, clips, masking and comparisons."""
