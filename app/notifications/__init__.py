"""Mails: written with the fact they tell, kept in an outbox until an SMTP server has them."""
