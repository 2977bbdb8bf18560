"""Clearance sheets: who made each sound, from what, and by which right the studio has it."""
