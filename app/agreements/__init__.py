"""Agreements of studio and designer, and their consequences."""
