"""Webhooks: signed messages about what happens, sent to addresses that a studio's producers set."""
