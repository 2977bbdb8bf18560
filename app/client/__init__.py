"""The command line of a game team's machine: `soundlist pull` and `soundlist why`, by the standard library alone."""
