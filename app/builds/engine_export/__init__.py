"""Engine export: the files by which an engine imports a pack, one module for each engine. No database."""
