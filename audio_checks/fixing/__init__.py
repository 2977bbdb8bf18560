"""Repairs that make a fixed copy from a master: gain, trim, name, header and depth. The master is only read."""
