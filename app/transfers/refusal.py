"""The error of this package."""


class TransferRefused(Exception):
    """A transfer that cannot be made: says what was found, what was wanted, how to fix it."""
