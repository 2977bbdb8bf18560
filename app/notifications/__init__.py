"""Emails: written in the transaction of their event, kept in an outbox until an SMTP server accepts them."""
