"""The delivery spec: what a delivered file may be, its limits, and what renders are made to.

A spec is read from TOML, merged with the one it extends, and looked at through views: for one
category, and for one target. Every view is a `DeliverySpec` whose limits hold for the files it
is used on; what is absent is not limited.
"""

import hashlib
import json
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

from audio_checks import check_names, spec_keys
from audio_checks.check_names import Level
from audio_checks.errors import SpecError
from audio_checks.name_tokens import Token
from audio_checks.spec_presets import new_spec
from audio_checks.spec_toml import to_toml

__all__ = [
    "Accept",
    "CueFacts",
    "DeliverySpec",
    "Engine",
    "Limits",
    "Naming",
    "Range",
    "Target",
    "load_spec",
    "new_spec",
    "parse_spec",
    "schema",
]

Tables = dict[str, Any]
CATEGORY_FOLDER = "{category}"


@dataclass(frozen=True)
class Range:
    """A lower and an upper bound; None does not limit."""

    min: float | None = None
    max: float | None = None

    def __bool__(self) -> bool:
        """Tell whether there is a bound at all."""
        return self.min is not None or self.max is not None


@dataclass(frozen=True)
class Accept:
    """What a file may be; None accepts anything that can be read."""

    containers: tuple[str, ...] | None = None
    encodings: tuple[str, ...] | None = None
    sample_rates_hz: tuple[int, ...] | None = None
    bit_depths: tuple[int, ...] | None = None
    channels: tuple[int, ...] | None = None
    layouts: tuple[str, ...] | None = None
    duration_s: Range = Range()


@dataclass(frozen=True)
class Limits:
    """The levels and edges a file must keep to; None does not limit."""

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


@dataclass(frozen=True)
class Naming:
    """How files are named: by a pattern, by tokens, or by the grammar of the Universal Category System.

    Attributes
    ----------
    tokens : tuple of Token
        What stands between separators; empty where a name is not made of tokens.
    ucs_ids : tuple of str
        The category ids that there are, for the grammar "ucs"; empty accepts any of the right form.
    portable : bool
        Whether a name must be one that every system can hold; so wherever anything else is said of names.
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
    """What the game adds to a sound, so that its file must come without."""

    adds: tuple[str, ...] = ()


@dataclass(frozen=True)
class Target:
    """What renders are made to, and what the game may keep of them in memory.

    Attributes
    ----------
    name : str
        A slug; also the folder that `audio-checks render` writes to.
    sample_rate_hz, bit_depth, encoding, channels : int, int, str, "master" or int
        The format; "master" keeps the master's channels.
    dither : {"tpdf", "shaped", "none"}
        Noise added where bits are lost.
    over_peak : {"attenuate", "refuse"}
        What happens to a file whose peaks exceed the limits.
    mono_gains : (float, float)
        What left and right are multiplied by before they are added to mono.
    chunks : {"sound", "all"}
        Which chunks of the master go along: what tells of the sound (loops, cue points with their
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
    """

    name: str
    sample_rate_hz: int
    bit_depth: int
    encoding: Literal["pcm", "float"] = "pcm"
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

    def path_of(self, file_name: str, category: str | None) -> str:
        """Return where a file of the target stands in a pack; a sound without a category skips that folder."""
        parts = [part.replace(CATEGORY_FOLDER, category or "") for part in self.folder.split("/")]
        return "/".join([part for part in parts if part] + [file_name])


@dataclass(frozen=True)
class CueFacts:
    """What the sound list says of one cue, as far as a check or a render needs it.

    `more` keeps the columns that no check reads (description, use, trigger, and any of the writer's own).
    """

    number: str
    name: str = ""
    file_name: str = ""
    category: str | None = None
    duration_s: float | None = None
    length_locked: bool = False
    frame_rate_fps: float | None = None
    loop: bool = False
    reverb: str | None = None
    variations: int = 1
    state: str = "concept"
    more: Mapping[str, str] = field(default_factory=dict, compare=False)


@dataclass(frozen=True)
class DeliverySpec:
    """A delivery spec, or the view of one for a category and a target.

    Attributes
    ----------
    tables : dict
        What was read, after `extend`, in plain values.
    category : str or None
        The category this view is for; it may have no tables of its own.
    target : Target or None
        The target this view judges renders of; None judges deliveries.
    kind : str or None
        What the category's sounds are (event, natural-decay, ambience, voice, music); None is unknown.
    checks : dict
        The severity the spec itself gives to checks, by name.
    categories : tuple of str
        The categories that have tables of their own; empty in a category's view.
    warnings : tuple of str
        What is lawful but probably not meant, in words.
    """

    tables: Tables
    name: str = ""
    folder: Path | None = None
    category: str | None = None
    target: Target | None = None
    kind: str | None = None
    accept: Accept = Accept()
    limits: Limits = Limits()
    naming: Naming = Naming()
    required_metadata: tuple[str, ...] = ()
    engine: Engine = Engine()
    targets: dict[str, Target] = field(default_factory=dict)
    checks: dict[str, Level] = field(default_factory=dict)
    categories: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    # Views made so far: whoever reads many files asks for the same few again and again.
    _views: dict[str, "DeliverySpec"] = field(default_factory=dict, init=False, repr=False, compare=False)

    @cached_property
    def sha256(self) -> str:
        """The hash of the canonical JSON of the tables; `[files]` says where, not what, and is left out."""
        said = {key: value for key, value in self.tables.items() if key != "files"}
        plain = json.dumps(said, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
        return hashlib.sha256(plain.encode("utf-8", "surrogatepass")).hexdigest()

    @cached_property
    def not_run(self) -> tuple[str, ...]:
        """The checks that the spec asks for and this version lacks, in the format's order."""
        asked = {name for name, level in self.checks.items() if level != "off"}
        here = check_names.present()
        return tuple(name for name in check_names.DEFAULT_SEVERITY if name in asked and name not in here)

    def for_category(self, name: str | None) -> "DeliverySpec":
        """Return the view for one category; a category without tables of its own gets the base tables."""
        if name is None:
            return self
        if name not in self.tables.get("categories", {}):
            return replace(self._made_view(""), category=name)
        return self._made_view(name)

    def _made_view(self, name: str) -> "DeliverySpec":
        if name not in self._views:
            self._views[name] = _view(_category_tables(self.tables, name), self.folder, category=name)
        return self._views[name]

    def for_target(self, name: str, category: str | None = None) -> "DeliverySpec":
        """Return the view that judges renders made to a target; SpecError when the spec names no such target.

        Rate, depth, encoding and channels must then equal the target's; everything else stays alike.
        """
        view = self.for_category(category)
        target = view.targets.get(name)
        if target is None:
            known = ", ".join(view.targets) or "none"
            raise SpecError(f'no target "{name}"; targets of this spec: {known}', where=f"targets.{name}")
        accept = Accept(
            containers=("wav",),
            encodings=(target.encoding,),
            sample_rates_hz=(target.sample_rate_hz,),
            bit_depths=(target.bit_depth,),
            channels=view.accept.channels if target.channels == "master" else (target.channels,),
            layouts=view.accept.layouts if target.channels == "master" else None,
            duration_s=view.accept.duration_s,
        )
        return _view(view.tables, self.folder, category=view.category, target=target, accept=accept)

    def category_of(self, path: str | Path) -> str | None:
        """Return the category that `[files]` gives to a path; the last matching glob wins."""
        from audio_checks.globs import matches

        found = None
        for glob, category in self.tables.get("files", {}).items():
            if matches(glob, path, self.folder):
                found = category
        return found

    def to_toml(self) -> str:
        """Return the spec as TOML that reads back to the same spec."""
        return to_toml(self.tables)


def parse_spec(text: str, *, where: str = "spec.toml") -> DeliverySpec:
    """Return the spec that a TOML text says.

    Raises
    ------
    SpecError
        The text is no TOML, or not a spec: its place is dotted, as in `spec.toml: limits.true_peak_dbtp`.
    """
    tables = _read(text, where)
    if "extend" in tables:
        raise SpecError("a spec that extends another must be read from its file", where=f"{where}: extend")
    for place, naming in _namings(tables):
        if "ucs_list" in naming:
            raise SpecError(
                "a spec that names a file must be read from its own; here, write the ids as ucs_ids",
                where=f"{where}: {place}.ucs_list",
            )
    return _spec(tables, None, where)


def load_spec(path: str | Path) -> DeliverySpec:
    """Return the spec of a file: a spec, an audio-checks.toml, or the table of a pyproject.toml.

    Raises
    ------
    SpecError
        The file cannot be read, or what it says, or what it extends, is not a spec.
    """
    path = Path(path)
    return _spec(_load(path, ()), path.absolute().parent, str(path))


def has_spec(path: Path) -> bool:
    """Tell whether a pyproject.toml has a table for audio-checks; any other file is a spec by its name."""
    return path.name != "pyproject.toml" or "audio-checks" in _toml(_text(path), str(path)).get("tool", {})


def schema() -> dict[str, Any]:
    """Return the JSON Schema of a delivery spec."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Delivery spec of audio-checks, format 1",
        **spec_keys.SPEC.schema(),
    }


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise SpecError(f"cannot be read: {error.strerror or error}", where=str(path)) from None
    except UnicodeDecodeError:
        raise SpecError("is not UTF-8 text", where=str(path)) from None


def _toml(text: str, where: str) -> Tables:
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise SpecError(f"is not TOML: {error}", where=where) from None


def _read(text: str, where: str, *, pyproject: bool = False) -> Tables:
    document = _toml(text, where)
    if pyproject:
        document = document.get("tool", {}).get("audio-checks", {})
    try:
        return dict(spec_keys.SPEC.read(document, ""))
    except SpecError as error:
        raise _placed(error, where) from None


def _load(path: Path, seen: tuple[Path, ...]) -> Tables:
    real = path.resolve()
    if real in seen:
        raise SpecError("extends itself in a circle", where=str(path))
    tables = _read(_text(path), str(path), pyproject=path.name == "pyproject.toml")
    for place, naming in _namings(tables):
        if "ucs_list" in naming:
            naming["ucs_ids"] = _cat_ids(path, naming.pop("ucs_list"), place)
    base = tables.pop("extend", None)
    return tables if base is None else merged(_load(path.parent / base, (*seen, real)), tables)


def _namings(tables: Tables) -> list[tuple[str, Tables]]:
    """Return the tables that say how files are named, each with its place."""
    places = [
        ("naming", tables),
        *((f"categories.{name}.naming", one) for name, one in tables.get("categories", {}).items()),
    ]
    return [(place, one["naming"]) for place, one in places if "naming" in one]


def _cat_ids(spec: Path, named: str, place: str) -> list[str]:
    from audio_checks.ucs import read_cat_ids

    try:
        return read_cat_ids(spec.parent / named)
    except SpecError as error:
        raise SpecError(f"{error.where}: {error.args[0]}", where=f"{spec}: {place}.ucs_list") from None


def merged(base: Tables, over: Tables) -> Tables:
    """Return the base with every value of `over` put on it: tables key by key, everything else whole."""
    whole = dict(base)
    for key, value in over.items():
        below = whole.get(key)
        whole[key] = merged(below, value) if isinstance(below, dict) and isinstance(value, dict) else value
    return whole


def _category_tables(tables: Tables, name: str) -> Tables:
    base = {key: value for key, value in tables.items() if key not in ("categories", "files")}
    own = tables.get("categories", {}).get(name, {})
    return merged(base, own)


def _spec(tables: Tables, folder: Path | None, where: str) -> DeliverySpec:
    """Return the spec of whole tables, once every view of it is known to hold."""
    if "format" not in tables:
        raise SpecError("the spec must say format = 1", where=f"{where}: format")
    try:
        spec = _view(tables, folder)
        warnings = list(_warnings_of(spec, ""))
        for name in spec.categories:
            for target in tables["categories"][name].get("targets", {}):
                if target not in spec.targets:
                    raise SpecError(
                        "a category may override a declared target, not add one",
                        where=f"categories.{name}.targets.{target}",
                    )
            try:
                view = spec.for_category(name)
            except SpecError as error:
                raise _placed(error, f"categories.{name}", ".") from None
            warnings += (
                one for one in _warnings_of(view, f"{name}: ") if one.removeprefix(f"{name}: ") not in warnings
            )
    except SpecError as error:
        raise _placed(error, where) from None
    return _view(tables, folder, warnings=tuple(warnings))


def _view(
    tables: Tables,
    folder: Path | None,
    *,
    category: str | None = None,
    target: Target | None = None,
    accept: Accept | None = None,
    warnings: tuple[str, ...] = (),
) -> DeliverySpec:
    checks = tables.get("checks", {})
    for name, level in checks.items():
        if level == "error" and name not in check_names.present():
            raise SpecError("this version has no such check, so it cannot be an error", where=f"checks.{name}")
    return DeliverySpec(
        tables=tables,
        name=tables.get("name", ""),
        folder=folder,
        category=category,
        target=target,
        kind=tables.get("kind"),
        accept=accept or _accept(tables.get("accept", {})),
        limits=_limits(tables.get("limits", {})),
        naming=_naming(tables.get("naming", {})),
        required_metadata=tuple(_stated(tables.get("metadata", {})).get("required", ())),
        engine=Engine(adds=tuple(tables.get("engine", {}).get("adds", ()))),
        targets={name: _target(name, keys) for name, keys in tables.get("targets", {}).items()},
        checks=checks,
        categories=tuple(tables.get("categories", ())),
        warnings=warnings,
    )


def _stated(table: Tables) -> Tables:
    """Return what is limited: "any" lifts a limit, and is as good as absent."""
    return {key: value for key, value in table.items() if value != spec_keys.ANY}


def _range(table: Tables | str | None, where: str) -> Range:
    bounds = Range(**_stated(table)) if isinstance(table, dict) else Range()
    if bounds.min is not None and bounds.max is not None and bounds.min > bounds.max:
        raise SpecError(f"min {bounds.min:g} is above max {bounds.max:g}", where=where)
    return bounds


def _accept(table: Tables) -> Accept:
    lists = {key: tuple(value) for key, value in _stated(table).items() if key != "duration_s"}
    return Accept(**lists, duration_s=_range(table.get("duration_s"), "accept.duration_s"))


def _limits(table: Tables) -> Limits:
    plain = {key: value for key, value in _stated(table).items() if key != "loudness_lufs"}
    return Limits(**plain, loudness_lufs=_range(table.get("loudness_lufs"), "limits.loudness_lufs"))


def _naming(table: Tables) -> Naming:
    said = _stated(table)
    rules = [key for key in ("pattern", "tokens", "grammar") if key in said]
    if len(rules) > 1:
        raise SpecError(
            f'a name has one rule, and here are {" and ".join(rules)}; lift the others, as in {rules[0]} = "any"',
            where="naming",
        )
    tokens = tuple(_token(keys, f"naming.tokens[{place}]") for place, keys in enumerate(said.pop("tokens", ())))
    ids = tuple(said.pop("ucs_ids", ()))
    portable = said.pop("portable", bool(rules) or "extension" in said)
    return Naming(**said, tokens=tokens, ucs_ids=ids, portable=portable)


def _token(keys: Tables, where: str) -> Token:
    if "name" not in keys:
        raise SpecError("a token must say it", where=f"{where}.name")
    rules = [key for key in ("one_of", "pattern", "digits", "case") if key in keys]
    if len(rules) > 1:
        raise SpecError(f"a token has one rule, and here are {' and '.join(rules)}", where=where)
    return Token(**{**keys, "one_of": tuple(keys.get("one_of", ()))})


def _target(name: str, keys: Tables) -> Target:
    where = f"targets.{name}"
    for needed in ("sample_rate_hz", "bit_depth"):
        if needed not in keys:
            raise SpecError("a target must say it", where=f"{where}.{needed}")
    encoding, depth = keys.get("encoding", "pcm"), keys["bit_depth"]
    lawful = (32, 64) if encoding == "float" else (8, 16, 24)
    if depth not in lawful:
        raise SpecError(
            f"{depth} bit is no depth for {encoding}; it can be {', '.join(map(str, lawful))}",
            where=f"{where}.bit_depth",
        )
    plain = encoding == "float" or depth == 24
    said = {"dither": "none" if plain else "tpdf", **_stated(keys), "name": name}
    if "mono_gains" in said:
        said["mono_gains"] = tuple(said["mono_gains"])
    target = Target(**said)
    if target.dither == "shaped" and target.sample_rate_hz < 44_100:
        raise SpecError(
            "shaped dither needs 44100 Hz or more: below, the noise has nowhere to hide", where=f"{where}.dither"
        )
    return target


def _warnings_of(spec: DeliverySpec, prefix: str) -> list[str]:
    rates = spec.accept.sample_rates_hz or ()
    found = [
        f"{prefix}accepts {rate} Hz, but target {target.name} is {target.sample_rate_hz} Hz: "
        "nothing is ever converted up, so its render of such a master will be refused"
        for target in spec.targets.values()
        for rate in rates
        if rate < target.sample_rate_hz
    ]
    extension = spec.naming.extension
    if extension is not None and not re.fullmatch(r"\.[A-Za-z0-9]+", extension):
        found.append(f'{prefix}naming.extension "{extension}" is not an ending such as ".wav"')
    return found


def _placed(error: SpecError, where: str, join: str = ": ") -> SpecError:
    return SpecError(error.args[0], where=f"{where}{join}{error.where}" if error.where else where)
