"""Adopted folders: their cues, takes and approvals."""
