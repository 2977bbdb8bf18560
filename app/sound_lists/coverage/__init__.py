"""Coverage of a game project's events by the list."""
