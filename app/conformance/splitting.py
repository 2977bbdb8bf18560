"""Code of the sandbox's child: writes the parts of a master into a folder."""

import audio_checks


def split(path: str, folder: str, *, shortest_pause_s: float) -> audio_checks.SplitMaster:
    """Split a master into a folder; return its parts."""
    return audio_checks.split_master(path, folder, shortest_pause_s=shortest_pause_s)
