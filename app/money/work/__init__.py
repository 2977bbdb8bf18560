"""Days and hours worked, and retainers."""
