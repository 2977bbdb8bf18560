"""From an award or an empty draft to a text that was sent: versions, their comparison, their PDF."""
