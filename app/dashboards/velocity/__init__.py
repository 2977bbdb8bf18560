"""The pace of a project, and its costs."""
