"""Redlines: what a designer proposes clause by clause, and what the studio answers."""
