"""Answers that several endpoints of deliveries give."""
