"""The phases of a production, and the gates between them."""
