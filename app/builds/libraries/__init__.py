"""Sound libraries that are registered by fingerprints."""
