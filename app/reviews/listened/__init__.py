"""Which takes a person has listened to."""
