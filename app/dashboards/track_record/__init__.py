"""A designer's record with one studio."""
