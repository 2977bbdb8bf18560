"""The security log of a studio."""
