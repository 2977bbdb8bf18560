"""The parts of a delivery spec, each as plain values, and how each is read from its table."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from audio_checks.errors import SpecError
from audio_checks.spec import kinds
from audio_checks.spec.check_names import LIMITS_OF_CHECKS
from audio_checks.spec.codings import CODINGS, DECODED_BITS, LOSSY_ENCODINGS, QUALITY, Coding
from audio_checks.spec.game_paths import game_path
from audio_checks.spec.name_tokens import Token

CATEGORY_FOLDER = "{category}"
WAV_ENDING = ".wav"
Encoding = Literal["pcm", "float", "vorbis", "opus", "flac"]
Tables = dict[str, Any]


@dataclass(frozen=True)
class Range:
    """A lower and an upper bound; None does not limit."""

    min: float | None = None
    max: float | None = None

    def __bool__(self) -> bool:
        """Return whether there is a bound at all."""
        return self.min is not None or self.max is not None


@dataclass(frozen=True)
class Accept:
    """Permitted forms of a file; None accepts anything that can be read."""

    containers: tuple[str, ...] | None = None
    encodings: tuple[str, ...] | None = None
    sample_rates_hz: tuple[int, ...] | None = None
    bit_depths: tuple[int, ...] | None = None
    channels: tuple[int, ...] | None = None
    layouts: tuple[str, ...] | None = None
    duration_s: Range = Range()
    bit_rate_kbps: Range = Range()


@dataclass(frozen=True)
class Limits:
    """The levels and edges a file must keep to; None does not limit.

    Their ranges are stated by the checks that hold files to them (`LIMITS`). `others` has limits that are not fields
    here, by key: a check that is added needs no change of this file.
    """

    sample_peak_dbfs: float | None = None
    true_peak_dbtp: float | None = None
    dc_offset_percent: float | None = None
    silence_below_dbfs: float | None = None
    head_silence_ms: float | None = None
    tail_silence_ms: float | None = None
    edge_silence_below_dbfs: float = -60.0
    tolerance_db: float = 0.05
    loudness_lufs: Range = Range()
    noise_floor_dbfs: float | None = None
    mono_loss_db: float | None = None
    low_level_dbfs: float | None = None
    variation_level_lu: float | None = None
    others: Mapping[str, float] = field(default_factory=dict, hash=False)


NO_LIMITS = Limits()
DEPTHS = {"float": (32, 64), "flac": (16, 24)}  # of a target's files, by encoding


@dataclass(frozen=True)
class Naming:
    """The naming of files: by a pattern, by tokens, or by the grammar of the Universal Category System.

    Attributes
    ----------
    tokens : tuple of Token
        What stands between separators; empty where a name is not made of tokens.
    ucs_ids : tuple of str
        The category ids that there are, for the grammar "ucs"; empty accepts any of the right form.
    portable : bool
        Whether a name must be one that every system can hold; always so where the spec has any other rule for names.
    """

    pattern: str | None = None
    extension: str | None = None
    tokens: tuple[Token, ...] = ()
    separator: str = "_"
    grammar: Literal["ucs"] | None = None
    ucs_ids: tuple[str, ...] = ()
    portable: bool = False


@dataclass(frozen=True)
class Engine:
    """The game's additions to a sound, so that its file must come without."""

    adds: tuple[str, ...] = ()


@dataclass(frozen=True)
class Target:
    """A goal for renders, and the game's memory budget for them.

    Attributes
    ----------
    name : str
        A slug; also the folder that `audio-checks render` writes to.
    sample_rate_hz, bit_depth, encoding, channels : int, int, str, "master" or int
        The format; "master" keeps the master's channels. What a lossy codec keeps has 32 bits: those it is decoded to.
    quality : float or None
        Of what a lossy codec keeps, from 0 to 1; None for any other encoding.
    dither : {"tpdf", "shaped", "none"}
        Noise added where bits are lost.
    over_peak : {"attenuate", "refuse"}
        What happens to a file whose peaks exceed the limits.
    mono_gains : (float, float)
        What left and right are multiplied by before they are added to mono.
    chunks : {"sound", "all"}
        Which chunks of the master go along: what describes the sound (loops, cue points with their
        labels, notes, tempo), or everything, names of people and projects included.
    shelf_db : float or "auto"
        By how much the top octave is lifted where the rate falls; "auto" by as much as the lost
        highs weigh, 6 dB at most.
    trim_below_dbfs : float or None
        Cut what stays below this level, or 60 dB under the peak if that is lower, at both ends. None cuts nothing.
    fade_in_ms, fade_out_ms : float
        Raised-cosine fades. What loops is neither trimmed nor faded.
    budget_bytes : int or None
        What all game files of the target may take in memory; stated for a category, what its files may.
    codec_ratio : float
        How many times smaller the engine's codec makes the PCM: PCM 1, ADPCM 4, Vorbis or Opus about 10.
    streamed : bool
        Whether the engine plays from disk: then only a buffer counts as memory.
    stream_buffer_bytes : int
        The buffer of one streamed file.
    folder : str
        Where the game looks for its files: folders with "/" between, "{category}" for the sound's own; "" is the top.
    keep_coded : bool
        Whether an adopted Ogg Vorbis, Opus or MP3 file is the game file as it is, whatever encoding, rate and channels
        the target has.
    """

    name: str
    sample_rate_hz: int
    bit_depth: int
    encoding: Encoding = "pcm"
    channels: Literal["master", 1, 2] = "master"
    dither: Literal["tpdf", "shaped", "none"] = "tpdf"
    over_peak: Literal["attenuate", "refuse"] = "attenuate"
    mono_gains: tuple[float, float] = (0.5, 0.5)
    chunks: Literal["sound", "all"] = "sound"
    shelf_db: float | Literal["auto"] = 0.0
    trim_below_dbfs: float | None = None
    fade_in_ms: float = 0.0
    fade_out_ms: float = 0.0
    budget_bytes: int | None = None
    codec_ratio: float = 1.0
    streamed: bool = False
    stream_buffer_bytes: int = 65_536
    folder: str = ""
    quality: float | None = None
    keep_coded: bool = False

    @property
    def coding(self) -> Coding | None:
        """Return the storage of files that are not plain samples in a WAV file."""
        return CODINGS.get(self.encoding)

    @property
    def is_lossy(self) -> bool:
        """Whether a codec changes the sound."""
        return self.coding is not None and self.coding.is_lossy

    def ending(self, of_wav: str | None = None) -> str:
        """Return the ending of file names: that of the codec's container, or a project's own for WAV files."""
        return self.coding.ending if self.coding else of_wav or WAV_ENDING

    def path_of(self, file_name: str, category: str | None, language: str | None = None) -> str:
        """Return the path of a target's file in the game; a sound without a category skips that folder.

        A voice line has a folder of its language, see `game_paths`.
        """
        parts = [part.replace(CATEGORY_FOLDER, category or "") for part in self.folder.split("/")]
        return game_path(language, "/".join([part for part in parts if part] + [file_name]))


@dataclass(frozen=True)
class CueFacts:
    """The sound list's facts on one cue, as far as a check or a render needs them.

    `more` keeps the columns that no check reads (description, use, trigger, and any of the writer's own).
    `duration_min_s` and `duration_max_s` are set where the list gives bounds ("at most 2 s"); `duration_s` is then the
    length to plan with. `says_loop` is whether the list has a column for loops at all.
    """

    number: str
    name: str = ""
    file_name: str = ""
    category: str | None = None
    duration_s: float | None = None
    duration_min_s: float | None = None
    duration_max_s: float | None = None
    length_locked: bool = False
    frame_rate_fps: float | None = None
    loop: bool = False
    reverb: str | None = None
    channels: str | None = None  # "mono" or "stereo"; None: as the spec says
    variations: int = 1
    state: str = "concept"
    more: Mapping[str, str] = field(default_factory=dict, compare=False)
    says_loop: bool = True

    @property
    def has_length_bounds(self) -> bool:
        """Whether the list bounds the length, in place of asking for one."""
        return self.duration_min_s is not None or self.duration_max_s is not None

    @property
    def plays_once(self) -> bool:
        """Whether the list says that the sound is no loop."""
        return self.says_loop and not self.loop

    @property
    def language(self) -> str | None:
        """The language of a voice line, of the column `language`; None for a cue that is no line."""
        return self.more.get("language") or None


def loops_by_itself(loops: Sequence[object], cue: CueFacts | None) -> bool:
    """Return whether a file loops by its own points, and the list does not say that its cue plays once."""
    return bool(loops) and not (cue is not None and cue.plays_once)


def read_accept(table: Tables) -> Accept:
    """Return the content of the table `accept`."""
    ranges = ("duration_s", "bit_rate_kbps")
    lists = {key: tuple(value) for key, value in stated(table).items() if key not in ranges}
    duration_s, bit_rate_kbps = (_range(table.get(key), f"accept.{key}") for key in ranges)
    return Accept(**lists, duration_s=duration_s, bit_rate_kbps=bit_rate_kbps)


def read_limits(table: Tables) -> Limits:
    """Return the content of the table `limits`."""
    plain = {key: value for key, value in stated(table).items() if key != "loudness_lufs"}
    others = {key: plain.pop(key) for key in LIMITS_OF_CHECKS if key in plain and not hasattr(NO_LIMITS, key)}
    return Limits(**plain, loudness_lufs=_range(table.get("loudness_lufs"), "limits.loudness_lufs"), others=others)


def read_naming(table: Tables) -> Naming:
    """Return the content of a table `naming`; SpecError where it gives a name two rules."""
    values = stated(table)
    rules = [key for key in ("pattern", "tokens", "grammar") if key in values]
    if len(rules) > 1:
        raise SpecError(
            f'a name has one rule, and here are {" and ".join(rules)}; lift the others, as in {rules[0]} = "any"',
            where="naming",
        )
    tokens = tuple(_token(keys, f"naming.tokens[{index}]") for index, keys in enumerate(values.pop("tokens", ())))
    ids = tuple(values.pop("ucs_ids", ()))
    portable = values.pop("portable", bool(rules) or "extension" in values)
    return Naming(**values, tokens=tokens, ucs_ids=ids, portable=portable)


def read_target(name: str, keys: Tables) -> Target:
    """Return the target of one of the tables `targets`; SpecError where no render can be made to it."""
    where = f"targets.{name}"
    encoding = keys.get("encoding", "pcm")
    is_lossy = encoding in LOSSY_ENCODINGS
    for needed in ("sample_rate_hz",) if is_lossy else ("sample_rate_hz", "bit_depth"):
        if needed not in keys:
            raise SpecError("a target must say it", where=f"{where}.{needed}")
    values = {**stated(keys), "name": name}
    if is_lossy:  # a depth and a dither that another category's files have say nothing here
        values |= {"bit_depth": DECODED_BITS, "dither": "none", "quality": values.get("quality", QUALITY)}
    else:
        _ensure_no_quality(values, encoding, where)
        depth = keys["bit_depth"]
        valid = DEPTHS.get(encoding, (8, 16, 24))
        if depth not in valid:
            raise SpecError(
                f"{depth} bit is not a depth for {encoding}; it can be {', '.join(map(str, valid))}",
                where=f"{where}.bit_depth",
            )
        values = {"dither": "none" if encoding == "float" or depth == 24 else "tpdf", **values}
    if encoding in CODINGS:
        _ensure_codable(CODINGS[encoding], keys["sample_rate_hz"], where)
    if "mono_gains" in values:
        values["mono_gains"] = tuple(values["mono_gains"])
    target = Target(**values)
    if target.dither == "shaped" and target.sample_rate_hz < 44_100:
        raise SpecError(
            "shaped dither needs 44100 Hz or more: below, the noise has nowhere to hide", where=f"{where}.dither"
        )
    return target


def _ensure_no_quality(values: Tables, encoding: str, where: str) -> None:
    if "quality" in values:
        raise SpecError(
            f'a quality is for {" and ".join(LOSSY_ENCODINGS)}, and the encoding here is "{encoding}"; '
            'take it out, or lift it with quality = "any"',
            where=f"{where}.quality",
        )


def _ensure_codable(coding: Coding, rate_hz: int, where: str) -> None:
    low, high = coding.lowest_hz, coding.highest_hz
    if not low <= rate_hz <= high:
        range_hz = f"{low} Hz" if low == high else f"{low} to {high} Hz"
        nearest = min(max(rate_hz, low), high)
        other = 'encoding = "vorbis"' if coding.label == "Opus" else "another encoding"
        raise SpecError(
            f"{coding.label} is made at {range_hz}, found {rate_hz} Hz; set sample_rate_hz = {nearest}, or {other}",
            where=f"{where}.sample_rate_hz",
        )


def stated(table: Tables) -> Tables:
    """Return the limits set: "any" lifts a limit, and is as good as absent."""
    return {key: value for key, value in table.items() if value != kinds.ANY}


def _range(table: Tables | str | None, where: str) -> Range:
    bounds = Range(**stated(table)) if isinstance(table, dict) else Range()
    if bounds.min is not None and bounds.max is not None and bounds.min > bounds.max:
        raise SpecError(f"min {bounds.min:g} is above max {bounds.max:g}", where=where)
    return bounds


def _token(keys: Tables, where: str) -> Token:
    if "name" not in keys:
        raise SpecError("a token must say it", where=f"{where}.name")
    rules = [key for key in ("one_of", "pattern", "digits", "case") if key in keys]
    if len(rules) > 1:
        raise SpecError(f"a token has one rule, and here are {' and '.join(rules)}", where=where)
    return Token(**{**keys, "one_of": tuple(keys.get("one_of", ()))})
