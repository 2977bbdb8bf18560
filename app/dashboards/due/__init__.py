"""What is due in a project, as a calendar."""
