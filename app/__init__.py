"""The Soundlist server: rooms over a kit, and the front doors main, worker and cli."""
