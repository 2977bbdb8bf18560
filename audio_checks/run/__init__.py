"""Many files in one run: which there are, what was judged before, processes, checks over sets."""
