"""The Soundlist server: rooms over a kit, and the entry points main, worker and cli."""
