"""Sums owed and paid under agreed contracts: ledger, invoices, payments, kill fees, extra rounds."""
