"""The review queue and the room in which a cue is heard."""
