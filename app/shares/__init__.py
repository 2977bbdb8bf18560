"""Shares: links for guests without an account, playlists, sessions in which all hear the same, and saved views."""
