"""Pictures of the places in sounds that mails lead to."""
