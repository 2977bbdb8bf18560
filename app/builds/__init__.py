"""Deliverables for the game and its reports: approved packs, documentation keys, reports of the game's CI."""
