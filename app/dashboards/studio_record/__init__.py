"""A studio's record as a client, for those who think of bidding."""
