"""Hours of work against the hours that designers have."""
