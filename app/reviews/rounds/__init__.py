"""Change requests and their rounds, comments and mentions."""
