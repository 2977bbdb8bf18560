"""The delivery spec and what belongs to it: keys, presets, sound lists, names, patterns."""
