"""Uploads: their destinations, headers and quotas."""
