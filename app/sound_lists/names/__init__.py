"""File names: what the spec refuses, and whose file a name is."""
