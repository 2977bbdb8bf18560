"""Packs of approved sounds: game files, masters, documentation, manifests, placeholders."""
