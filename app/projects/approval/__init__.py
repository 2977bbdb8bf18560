"""Who may approve sounds."""
