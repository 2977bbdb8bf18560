"""Erasure of people, projects and studios."""
