"""Invoices, on paper and for programs."""
