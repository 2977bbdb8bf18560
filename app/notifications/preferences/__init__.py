"""The mails that each person wants."""
