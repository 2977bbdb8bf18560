"""Compares the sounds of a game build with those that were approved: what is the same, and what happened to the rest.

`fingerprint` keeps what a sound is known by, `likeness` compares two of them, `search` finds which of
many are worth that, `statuses` says what happened to each file. `manifest` is the approved sounds as a
file; `audit_build` does it all.
"""
