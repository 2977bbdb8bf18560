"""HTTP: requests, answers, limits and serving, without a word of the domain."""
