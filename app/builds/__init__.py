"""What the game gets and says: approved packs, documentation keys, reports of the game's own CI."""
