"""The sound list that `--list` names, and what is said of how it was read."""

from pathlib import Path

from audio_checks.cli.terminal import note
from audio_checks.spec.sound_list import SoundList, read_sound_list

MOST_NOTES = 20


def named_list(path: str) -> SoundList:
    """Return the sound list of a file, and say what was guessed, left out or not read."""
    sound_list = read_sound_list(Path(path))
    for sentence in sound_list.notes[:MOST_NOTES]:
        note(f"{path}: {sentence}")
    if len(sound_list.notes) > MOST_NOTES:
        note(f"{path}: and {len(sound_list.notes) - MOST_NOTES} more like these")
    return sound_list
