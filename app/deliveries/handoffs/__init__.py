"""Hand-offs of a cue from one maker to the next."""
