"""Preview reels."""
