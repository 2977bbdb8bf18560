"""Audits of game builds: what ships is held against what was approved."""
