"""Deliveries: uploads become takes, matched to their cue by name or waiting in the unmatched tray."""
