"""Kits: lists of starter cues."""
