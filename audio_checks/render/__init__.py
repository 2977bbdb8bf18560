"""How game files are made from masters: rate, channels, depth, peaks, and previews for the ear."""
