"""Second factors: authenticator apps, recovery codes, and what a studio requires one for."""
