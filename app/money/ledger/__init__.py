"""The ledger of a contract, and the journal for accountants."""
