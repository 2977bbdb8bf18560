"""The making of game files from masters: rate, channels, depth, peaks, and previews for the ear."""
