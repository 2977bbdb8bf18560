"""Names of files as they come from designers, made from real lists; nothing of the reader is used here."""

import random
import re
from dataclasses import dataclass
from pathlib import Path

LISTS = Path(__file__).with_name("lists")
HELD_OUT = 0.15  # of a list's sounds are not asked for: their files belong to no cue
STUDIO, PROJECT, PREFIX, DESIGNER = "Blue Harbour", "Star Whale", "SW", "Jane Doe"


@dataclass(frozen=True)
class Cue:
    """A line of a list."""

    stem: str
    variations: int = 1


@dataclass(frozen=True)
class Messy:
    """A messy name, and the cue and variation that it is for; None for none that the list has."""

    path: str
    cue: str | None
    variation: int | None


def names_of(list_name: str) -> list[str]:
    """Return the stems of a list."""
    return (LISTS / f"{list_name}.txt").read_text(encoding="utf-8").split("\n")[:-1]


def make(names: list[str], seed: int, each: int = 2) -> tuple[list[Cue], list[Messy]]:
    """Return a list made of names, and messy names for it."""
    dice = random.Random(seed)
    every, singles = _sets(names, dice)
    strangers = [name for name in singles if dice.random() < HELD_OUT]
    singles = [name for name in singles if name not in strangers]
    cues = [cue for cue in every if cue.stem not in strangers]
    messy = []
    for _ in range(each):
        messy += [Messy(_path(name, "", dice, ""), name, 1) for name in singles]
        messy += [Messy(_path(name, "", dice, ""), None, None) for name in strangers]
        for cue in cues:
            if cue.variations == 1:
                continue
            for place in range(1, cue.variations + 1):
                written = dice.choice(
                    [f"_{place:02}", f"_{place}", f"-{place:02}", f" {place}", f"{place}", f"_{place:03}"]
                )
                messy.append(Messy(_path(cue.stem, written, dice, "set"), cue.stem, place))
            messy.append(Messy(_path(cue.stem, "", dice, "set"), None, None))
            over = cue.variations + dice.randint(1, 4)
            messy.append(Messy(_path(cue.stem, f"_{over:02}", dice, "set"), None, None))
    return cues, messy


def _sets(names: list[str], dice: random.Random) -> tuple[list[Cue], list[str]]:
    groups: dict[str, list[str]] = {}
    for name in names:
        found = re.fullmatch(r"(.*[^\W\d_])[ _-]?([0-9]{1,2})", name)
        if found:
            groups.setdefault(found[1], []).append(name)
    taken = {name.casefold() for name in names}
    cues, gone = [], set()
    for stem, members in groups.items():
        if len(members) >= 3 and dice.random() < 0.5 and stem.casefold() not in taken:
            cues.append(Cue(stem, len(members)))
            gone.update(members)
    singles = [name for name in names if name not in gone]
    return cues + [Cue(name) for name in singles], singles


def _words(name: str) -> list[str]:
    return [word for word in re.split(r"[^A-Za-z0-9]+|(?<=[a-z])(?=[A-Z])", name) if word]


def _spelt(name: str, number: str, dice: random.Random) -> str:
    words = _words(name)
    way = dice.randrange(9)
    if way == 0:
        return name + number
    if way == 1:
        return (name + number).upper()
    if way == 2:
        return "".join(word[:1].upper() + word[1:] for word in words) + number.lstrip("_- ")
    if way == 3:
        return (words[0].lower() + "".join(word[:1].upper() + word[1:] for word in words[1:])) + number
    between = dice.choice(" -._ ")
    if way in (4, 5):
        return between.join(word.lower() for word in words) + re.sub("[_ -]", between, number)
    if way == 6:
        return between.join(word.capitalize() for word in words) + re.sub("[_ -]", between, number)
    if way == 7:
        return between.join(word.upper() for word in words) + re.sub("[_ -]", between, number)
    return name.title() + number


def _date(dice: random.Random) -> str:
    year, month, day = dice.randint(2021, 2026), dice.randint(1, 12), dice.randint(1, 28)
    return dice.choice(
        [
            f"{year}{month:02}{day:02}",
            f"{year}-{month:02}-{day:02}",
            f"{year}_{month:02}_{day:02}",
            f"{year % 100}{month:02}{day:02}",
            f"{day:02}.{month:02}.{year}",
            f"{day:02}-{month:02}-{year % 100}",
            f"{day:02}{month:02}{year}",
        ]
    )


def _path(name: str, number: str, dice: random.Random, kind: str) -> str:
    text = _spelt(name, number, dice)
    folder = ""
    for _ in range(dice.choice([0, 1, 1, 1, 2, 2, 3])):
        text, folder = _soiled(text, folder, name, dice, kind)
    ending = dice.choice([".wav", ".wav", ".wav", ".WAV", ".aif", ".flac", ".wav.wav"])
    return f"{folder}{text}{ending}"


def _soiled(text: str, folder: str, name: str, dice: random.Random, kind: str) -> tuple[str, str]:
    between = dice.choice("__- ")
    way = dice.randrange(11)
    if way == 0:
        state = dice.choice(
            ["FINAL", "final", "Final", "FINAL2", "final_FINAL", "NEW", "master", "WIP", "bounce", "final3"]
        )
        return text + between + state, folder
    if way == 1:
        return text + dice.choice(["_v2", "_v03", " v3", "-V4", "_rev2", "_ver3", ".v2", "_v1.2", "V2"]), folder
    if way == 2:
        copies = [" (1)", " copy", " - Copy", " copy 2", " - Kopie", "(1)"]
        return text + dice.choice(copies + ([] if kind else [" (2)", " (3)"])), folder
    if way == 3:
        return text + between + _date(dice), folder
    if way == 4:
        return _date(dice) + between + text, folder
    if way == 5:
        return dice.choice(
            ["SW", "sw", "StarWhale", "star_whale", "JD", "jd", "jane", "JaneDoe", "sfx", "SFX"]
        ) + between + text, folder
    if way == 6:
        return dice.choice(["ACM", "mk", "TKR", "Nordlicht", "proj7", "ab", "RX"]) + between + text, folder
    if way == 7:
        cat_id = dice.choice(["UIClick", "GUNAuto", "AMBForst", "DSGNMisc", "WATRSplsh", "MAGCSpel", "FOLYFeet"])
        return f"{cat_id}_{text}{dice.choice(['_JD_SW', '_JDOE_STARWHALE', '_MK_SRC', ''])}", folder
    if way == 8:
        folder = dice.choice(
            ["UI/", "delivery 3/", "FINAL/", "Round 2 (final)/", "2024-11-23/sounds/", "C:\\Users\\jane\\Desktop\\"]
        )
        return text, folder
    if way == 9:
        return text + dice.choice(["_altB", "_alt2", " ALT C", "__alt3", "-altb"]), folder
    return text + dice.choice(["_48k", "_24bit", "_96k24b", " stereo", "_mono", "_48kHz_24bit", "-6dB"]), folder
