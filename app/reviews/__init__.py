"""The review queue: verdicts, change requests and rounds, comments, cuts."""
