"""Repairs that make a mended copy from a master: gain, trim, name, header and depth. The master is only read."""
