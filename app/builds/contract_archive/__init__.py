"""What a contract that has ended leaves for the next designer."""
