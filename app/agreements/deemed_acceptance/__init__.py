"""The acceptance of a cue by a clause, when its days are over without a verdict."""
