"""The sources of takes."""
