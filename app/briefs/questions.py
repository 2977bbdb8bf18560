"""The questions of the brief, as plain data: practices P17 to P28 of the field, in words for people new to audio."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum


class AnswerKind(StrEnum):
    """The kind of content of an answer."""

    CHOICE = "choice"  # the key of one choice
    CHOICES = "choices"  # the keys of some choices
    TEXT = "text"
    NUMBER = "number"
    LINES = "lines"  # short texts, one a line
    PER_CATEGORY = "per_category"  # for each category, the keys of some choices
    PER_SCENE = "per_scene"  # scenes, each with its ambience and whether music plays
    NAMES = "names"  # the parts of a file name


@dataclass(frozen=True)
class Choice:
    """One answer that can be picked."""

    key: str
    label: str


@dataclass(frozen=True)
class Question:
    """One question of the brief."""

    key: str
    topic: str
    text: str
    why: str
    example: str
    kind: AnswerKind
    choices: tuple[Choice, ...] = ()
    unit: str = ""
    required: bool = False
    only_if: tuple[str, frozenset[str]] | None = None  # asked only if the answer of that question is one of these
    writes: str = ""  # the table of the delivery spec that the answer writes


@dataclass(frozen=True)
class Topic:
    """Questions that are answered together, on one page."""

    key: str
    title: str
    lead: str


EVERYTHING = "everything"  # the row of a PER_CATEGORY answer for the categories that have none of their own
CATEGORIES = (
    ("ambience", "Ambience: rooms, weather, crowds"),
    ("foley", "Foley: steps, cloth, handling"),
    ("ui", "Interface: menus, clicks, confirmations"),
    ("weapon", "Weapons"),
    ("impact", "Impacts and destruction"),
    ("creature", "Creatures and animals"),
    ("vehicle", "Vehicles and machines"),
    ("music", "Music"),
    ("vo", "Voice: dialogue, commands, shouts"),
    ("narration", "Narration"),
    ("cinematic", "Cinematics and trailers"),
)

TOPICS = (
    Topic("game", "The game and its feel", "What the sounds belong to, and how they should feel."),
    Topic("platforms", "Platforms and playback", "Where the game runs, and on what players hear it."),
    Topic("ambience", "Ambience", "What is heard while nothing happens, scene by scene."),
    Topic("music", "Music under the effects", "Effects must sit with the music that plays at the same time."),
    Topic("alone", "What stands alone", "The sounds that a player must never miss get the most work."),
    Topic("voice", "Voice and narration", "Who speaks in the game, and who makes the recordings."),
    Topic("engine", "Engine, memory, names", "What the game does to a sound must not be in the file."),
    Topic("licensed", "Licensed material", "Sounds of a film, a brand or an earlier game."),
    Topic("surround", "Surround", "More than two channels cost work: say what is planned."),
    Topic("people", "People and dates", "Who puts the sounds into the game, and by when."),
)

_HANDHELD = ("handheld", "phone", "web", "vr")
_SPOKEN = frozenset({"calls", "dialogue"})

QUESTIONS = (
    Question(
        "genre",
        "game",
        "What kind of game is it?",
        "A racing game and a card game ask for different sounds, and for different amounts of them.",
        "A side-scrolling platformer for children; a session lasts 10 minutes.",
        AnswerKind.TEXT,
        required=True,
    ),
    Question(
        "feel",
        "game",
        "How should the game feel to the ear?",
        "Feel decides sources and processing before any single sound does.",
        "Warm and handmade: wood, paper and cloth, nothing electronic.",
        AnswerKind.TEXT,
        required=True,
    ),
    Question(
        "similar",
        "game",
        "Which games, films or recordings does it sound like?",
        "One example says more than a page of adjectives.",
        "One title a line, and what of it is meant: “the menus of …”, “the footsteps in …”.",
        AnswerKind.LINES,
    ),
    Question(
        "categories",
        "game",
        "Which kinds of sound does the game have?",
        "Each kind has limits of its own, and the list is checked against this answer.",
        "Interface, foley and ambience; no weapons.",
        AnswerKind.CHOICES,
        choices=tuple(Choice(key, label) for key, label in CATEGORIES),
        required=True,
        writes="categories",
    ),
    Question(
        "platforms",
        "platforms",
        "On which platforms does the game run?",
        "The smallest platform decides how much memory sounds may take.",
        "PC first, a handheld console half a year later.",
        AnswerKind.CHOICES,
        choices=(
            Choice("pc", "PC or Mac"),
            Choice("console", "Console"),
            Choice("handheld", "Handheld console"),
            Choice("phone", "Phone or tablet"),
            Choice("web", "Web browser"),
            Choice("vr", "VR headset"),
        ),
        required=True,
        writes="targets",
    ),
    Question(
        "playback",
        "platforms",
        "On what will most players listen?",
        "The mix is made for what most players use: a phone’s speaker plays no deep bass.",
        "Small speakers of the handheld; a third use headphones.",
        AnswerKind.CHOICE,
        choices=(
            Choice("small_speakers", "Small speakers: phone, handheld, laptop"),
            Choice("tv", "Television"),
            Choice("headphones", "Headphones"),
            Choice("speakers", "Good speakers or a soundbar"),
            Choice("theatre", "Home theatre"),
        ),
        required=True,
    ),
    Question(
        "scenes",
        "ambience",
        "Which scenes does the game have, and what is heard in each while nothing happens?",
        "A game is never silent: a scene has an ambience, or music, or both.",
        "Harbour: gulls, water on wood, distant ropes; music only at night.",
        AnswerKind.PER_SCENE,
        required=True,
    ),
    Question(
        "silence",
        "ambience",
        "Is there any moment that is silent on purpose?",
        "Players take silence for a fault unless it is meant.",
        "Two seconds before the whale surfaces.",
        AnswerKind.CHOICE,
        choices=(Choice("never", "Never"), Choice("some", "At some moments, described below")),
    ),
    Question(
        "music_style",
        "music",
        "What music plays while effects are heard?",
        "Effects share the frequencies that the music leaves free.",
        "Soft strings and harp in the levels; loud drums in boss fights.",
        AnswerKind.TEXT,
        required=True,
    ),
    Question(
        "music_ducks",
        "music",
        "Does the game lower the music when something important is heard?",
        "If it does not, an effect must be heard over the music by itself.",
        "By 6 dB while anyone speaks.",
        AnswerKind.CHOICE,
        choices=(
            Choice("yes", "Yes"),
            Choice("voice", "For voice only"),
            Choice("no", "No"),
        ),
    ),
    Question(
        "priority",
        "alone",
        "Which sounds must be heard over everything, and stand alone?",
        "They get the most work, and the game plays them first when voices run out.",
        "Shield hit; low health; the coin; the boss’s roar.",
        AnswerKind.LINES,
        required=True,
    ),
    Question(
        "voice",
        "voice",
        "Does anyone speak in the game?",
        "Voice has limits of its own, and commands must be heard over everything.",
        "Short shouts in battle, no dialogue.",
        AnswerKind.CHOICE,
        choices=(
            Choice("none", "No"),
            Choice("calls", "Shouts and short commands"),
            Choice("dialogue", "Dialogue"),
        ),
        required=True,
    ),
    Question(
        "voice_people",
        "voice",
        "Who writes, casts, directs and records the voices?",
        "Each of these can be part of a sound designer’s job, and has a price.",
        "The studio writes and casts; the designer records and directs in one day.",
        AnswerKind.TEXT,
        required=True,
        only_if=("voice", _SPOKEN),
    ),
    Question(
        "narration",
        "voice",
        "Is there a narrator?",
        "A narration needs a speaker, a room, a director and a background to speak over.",
        "An old sailor, between the levels, over soft music.",
        AnswerKind.CHOICE,
        choices=(Choice("no", "No"), Choice("yes", "Yes"), Choice("recorded", "Yes, and it is recorded already")),
        required=True,
    ),
    Question(
        "narration_people",
        "voice",
        "Who records, directs and speaks the narration, and what plays under it?",
        "A missing director costs a second session.",
        "A speaker whom the studio knows; nobody directs yet; harp under it.",
        AnswerKind.TEXT,
        required=True,
        only_if=("narration", frozenset({"yes"})),
    ),
    Question(
        "effects",
        "engine",
        "Which effects does the game add while it plays?",
        "What the game adds must not be in the file, or it is heard twice.",
        "Reverb on everything but menus; Doppler on vehicles.",
        AnswerKind.PER_CATEGORY,
        choices=(
            Choice("reverb", "Reverb"),
            Choice("occlusion", "Occlusion"),
            Choice("pitch", "Pitch"),
            Choice("doppler", "Doppler"),
        ),
        required=True,
        writes="engine",
    ),
    Question(
        "player",
        "engine",
        "What plays the sounds in the game?",
        "Each engine is best handed another format.",
        "Unity, without middleware.",
        AnswerKind.CHOICE,
        choices=(
            Choice("wwise", "Wwise"),
            Choice("fmod", "FMOD Studio"),
            Choice("unreal", "Unreal Engine"),
            Choice("unity", "Unity"),
            Choice("raw", "An engine of our own"),
        ),
        required=True,
        writes="targets",
    ),
    Question(
        "quality",
        "engine",
        "In which quality should the masters arrive?",
        "Converting down takes minutes; converting up is impossible.",
        "As a game of today needs it, unless a film or a trailer is planned.",
        AnswerKind.CHOICE,
        choices=(
            Choice("48k", "48 kHz, 24 bit: usual today"),
            Choice("44k1", "44.1 or 48 kHz, 16 or 24 bit: older engines, small teams"),
        ),
        writes="accept",
    ),
    Question(
        "memory",
        "engine",
        "How much memory may sounds take on the smallest platform?",
        "The budget decides lengths, rates and how many variations there can be.",
        "8 MB on the handheld.",
        AnswerKind.NUMBER,
        unit="MB",
        writes="targets",
    ),
    Question(
        "naming",
        "engine",
        "How is a file named?",
        "Files arrive under the names that the game expects, so nobody renames them by hand.",
        "foot_deck_walk_01.wav: what it is, details, the variation’s number.",
        AnswerKind.NAMES,
        required=True,
        writes="naming",
    ),
    Question(
        "loudness",
        "engine",
        "Does the game mix the sounds, or do they come mixed?",
        "Mixed by the game: one loudness for a category. Mixed before: each sound as loud as it plays.",
        "The game mixes; everything of one category comes equally loud.",
        AnswerKind.CHOICE,
        choices=(Choice("game", "The game mixes"), Choice("mixed", "They come mixed")),
        required=True,
    ),
    Question(
        "licensed",
        "licensed",
        "Must any sound come from, or resemble, a film, a brand or an earlier game?",
        "Originals need a licence; without one they must be made again.",
        "The chime of the television series.",
        AnswerKind.CHOICE,
        choices=(
            Choice("no", "No"),
            Choice("originals", "Yes, originals may be used"),
            Choice("made", "Yes, made again for this game"),
        ),
        required=True,
    ),
    Question(
        "licensed_terms",
        "licensed",
        "Which originals, and under which terms?",
        "A designer must know what may be changed, and for how long it may be used.",
        "The chime, unchanged, in the game and its trailer, until 2030.",
        AnswerKind.TEXT,
        required=True,
        only_if=("licensed", frozenset({"originals"})),
    ),
    Question(
        "surround",
        "surround",
        "In how many channels does the game play?",
        "Beds for surround are other recordings than stereo ones.",
        "Stereo; the launch trailer in 5.1.",
        AnswerKind.CHOICES,
        choices=(
            Choice("stereo", "Mono and stereo"),
            Choice("5.1", "5.1"),
            Choice("7.1", "7.1"),
            Choice("ambisonic", "Ambisonics (first order)"),
        ),
        writes="accept",
    ),
    Question(
        "implementer",
        "people",
        "Who puts the sounds into the game?",
        "A designer asks this person how a sound is triggered, and hears it in the game through them.",
        "The gameplay programmer, within two days of approval.",
        AnswerKind.TEXT,
        required=True,
    ),
    Question(
        "dates",
        "people",
        "Which dates are fixed?",
        "A date that is known now can be planned for; one that is not becomes a rush.",
        "Alpha 1 February, beta 1 April, nothing new after 15 April.",
        AnswerKind.TEXT,
    ),
)
BY_KEY: Mapping[str, Question] = {question.key: question for question in QUESTIONS}
SMALL_PLATFORMS = frozenset(_HANDHELD)
