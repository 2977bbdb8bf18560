"""Which events of a game project the list covers."""
