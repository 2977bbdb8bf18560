"""The next step of each person."""
