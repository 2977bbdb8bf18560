"""The sample project: a small list with sounds to review, made in a studio and deleted by one request."""
