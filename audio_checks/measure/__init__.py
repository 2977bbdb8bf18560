"""Figures of sound: arrays in, numbers out. No files, no spec, no findings."""
