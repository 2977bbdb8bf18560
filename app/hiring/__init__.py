"""Postings of work, the bids on them, and how a team compares and awards them."""
