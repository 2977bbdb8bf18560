"""Speed and quality against peers."""
