"""The details on invoices of a person who sells and of a studio that buys."""
