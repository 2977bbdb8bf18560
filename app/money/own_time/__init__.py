"""Time that a person logs without a contract, for their own figures."""
