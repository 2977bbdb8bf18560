"""The same sound in other projects of a studio."""
