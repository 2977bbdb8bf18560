"""The sound list: cues, the names they own, revisions, imports and questions."""
