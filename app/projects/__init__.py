"""Projects: their delivery spec, liaisons and decider, engagements and the invitations of designers."""
