"""Bids, their samples and comparison."""
