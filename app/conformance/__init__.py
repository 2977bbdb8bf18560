"""The one verdict: every take is checked against the spec in a child process that may crash."""
