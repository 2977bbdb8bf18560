"""Studios, people, roles, sessions, tokens and the invitations into a studio."""
