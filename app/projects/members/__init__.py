"""The members of the studio who are in a project, and what the others see of it: nothing, where the studio wants it."""
