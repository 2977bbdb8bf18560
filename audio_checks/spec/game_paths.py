"""The place of voice lines' files: one rule for sound lists, packs, placeholders and checks.

A cue that is a line in one language owns a name that begins with the language (`en_captain_010`), so that no two
cues own one name. In the game every language has a folder, and the line has one name in all of them
(`en/captain_010.wav`), which is what engines expect of localised sound.
"""


def stem_in_language(language: str, stem: str) -> str:
    """Return the name that the cue of a line owns in one language: the language, then the line's name."""
    return f"{language}_{stem}"


def game_path(language: str | None, path: str) -> str:
    """Return the place of a cue's file in the game.

    Parameters
    ----------
    language : str or None
        The language of a line, as a tag such as `pt-BR`; None for a cue that is no line.
    path : str
        The folder of the file, with slashes, and the name that the cue owns.

    Returns
    -------
    str
        For a line, a folder of its language and the name without it; a cue that is no line, or is not
        named after its language, stays where it is.
    """
    folder, slash, name = path.rpartition("/")
    start = stem_in_language(language, "") if language else ""
    if not start or not name.startswith(start) or name == start:
        return path
    return f"{folder}{slash}{language}/{name.removeprefix(start)}"
