"""Bonuses of contracts."""
