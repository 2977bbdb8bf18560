"""The due things of a project, as a calendar."""
