"""The demo project "Shield Wing": its sounds, made from nothing by our own synthesiser."""
