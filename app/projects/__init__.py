"""Projects: their delivery spec, liaisons and approver, engagements and the invitations of designers."""
