"""Demands of the operating system: paths, text files, isolated processes."""
