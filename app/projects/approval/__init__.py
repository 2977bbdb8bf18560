"""Approvers of sounds."""
