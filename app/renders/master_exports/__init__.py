"""Masters handed out with their provenance."""
