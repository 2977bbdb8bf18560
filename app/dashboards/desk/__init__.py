"""A designer's desk."""
