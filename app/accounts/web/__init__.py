"""HTTP of accounts: who is asking, how often, and the cookies of browsers."""
