"""Reasons for a command to end with its task undone."""

DONE, NOT_AS_APPROVED, REFUSED, UNREACHABLE = 0, 1, 2, 3  # exit codes


class Refusal(Exception):
    """A command cannot do what was asked; the message says why, and how to put it right."""


class ServerUnreachable(Exception):
    """The server does not answer, or is too busy to."""


class NotFetched(Exception):
    """One file could not be fetched; the others go on."""
