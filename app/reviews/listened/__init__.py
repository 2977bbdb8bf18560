"""The takes that a person has listened to."""
