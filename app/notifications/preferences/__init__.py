"""What each person wants to be mailed."""
