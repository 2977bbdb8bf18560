"""Signatures, their codes and drawn names, and the seal of a signed contract."""
