"""What a run says of files: findings, reports, and the verdicts in them."""
