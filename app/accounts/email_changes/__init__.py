"""Changes of an account's email address, confirmed at both addresses."""
