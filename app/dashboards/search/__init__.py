"""Search in one project or all."""
