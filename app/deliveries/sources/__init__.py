"""What takes were made from."""
