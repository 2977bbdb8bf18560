"""Postings of work and who may see them."""
