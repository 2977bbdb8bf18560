"""A run's statements on files: findings, reports, and the verdicts in them."""
