"""The corpus that audits are evaluated on: what builds do to approved sounds."""
