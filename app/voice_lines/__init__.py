"""Voice lines: the script by character and language, its takes, pick-ups, and the releases of performers."""
