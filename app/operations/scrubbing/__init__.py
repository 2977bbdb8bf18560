"""Stored files, read again and held against the hashes of their rows."""
