"""Everything of a server to another database or store, and everything of a studio into one file and out of it."""
