"""How fast a project goes, and what it costs."""
