"""The projects of a designer, for their own page."""
