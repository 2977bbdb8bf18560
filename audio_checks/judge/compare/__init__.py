"""Reverb judged by comparison: with a dry stem, or with an earlier take."""
