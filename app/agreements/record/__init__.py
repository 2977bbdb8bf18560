"""The record of a contract, chained by hashes, and its verification."""
