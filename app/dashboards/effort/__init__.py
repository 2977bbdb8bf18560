"""Hours that cues are likely to take, and the days on which they can be done."""
