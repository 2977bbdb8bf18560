"""Listening in the running game, and the tasks that come from it."""
