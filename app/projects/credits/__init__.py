"""Names in credits."""
