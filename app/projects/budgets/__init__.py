"""Budgets of projects."""
