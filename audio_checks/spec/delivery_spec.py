"""The delivery spec: what a delivered file may be, its limits, and what renders are made to.

A spec is read from TOML, merged with the one it extends, and looked at through views: for one
category, and for one target. Every view is a `DeliverySpec` whose limits hold for the files it
is used on; what is absent is not limited.
"""

import hashlib
import json
import re
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import chain, islice
from pathlib import Path
from typing import Any

from audio_checks.errors import SpecError
from audio_checks.metadata.layouts import LAYOUTS
from audio_checks.spec import check_names
from audio_checks.spec import keys as spec_keys
from audio_checks.spec.check_names import Level
from audio_checks.spec.files import load_tables, merged, namings, placed, read_tables, with_lines
from audio_checks.spec.kinds import each_read
from audio_checks.spec.parts import (
    WAV_ENDING,
    Accept,
    CueFacts,
    Engine,
    Limits,
    Naming,
    Range,
    Tables,
    Target,
    read_accept,
    read_limits,
    read_naming,
    read_target,
    stated,
)
from audio_checks.spec.presets import new_spec
from audio_checks.spec.toml import to_toml
from audio_checks.system.text_files import read_text

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

MOST_WARNINGS = 100


@dataclass(frozen=True)
class DeliverySpec:
    """A delivery spec, or the view of one for a category and a target.

    Attributes
    ----------
    tables : dict
        The content, after `extend`, in plain values.
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
        Valid settings that are probably not meant, as sentences.
    """

    tables: Tables
    name: str = ""
    folder: Path | None = None
    category: str | None = None
    target: Target | None = None
    kind: str | None = None
    accept: Accept = field(default_factory=Accept)
    limits: Limits = field(default_factory=Limits)
    naming: Naming = field(default_factory=Naming)
    required_metadata: tuple[str, ...] = ()
    engine: Engine = field(default_factory=Engine)
    targets: dict[str, Target] = field(default_factory=dict)
    checks: dict[str, Level] = field(default_factory=dict)
    categories: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    # Cached views: a run over many files needs the same few.
    _views: dict[str, "DeliverySpec"] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def ending(self) -> str:
        """Return the ending of file names: of deliveries, or of the target's game files."""
        if self.target is not None:
            return self.target.ending(self.naming.extension)
        return self.naming.extension or WAV_ENDING

    def asks_for_dry_sound(self, cue: CueFacts | None) -> bool:
        """Return whether reverb is a fault: the game adds it, or the check or the cue asks for dry, and not a tail."""
        is_dry = cue is not None and cue.reverb == "dry"
        is_asked = is_dry or "reverb" in self.engine.adds or "baked-reverb" in self.checks
        return is_asked and (cue is None or cue.reverb != "designed-tail")

    def channels_for(self, cue: CueFacts | None) -> tuple[int, ...] | None:
        """Return the accepted numbers of channels: the target's own, else the cue's, else the spec's; None for any."""
        is_folded = self.target is not None and self.target.channels != "master"
        if cue is None or cue.channels is None or is_folded:
            return self.accept.channels
        return (LAYOUTS[cue.channels].channels,)

    @cached_property
    def sha256(self) -> str:
        """The hash of the canonical JSON of the tables; `[files]` says where, not what, and is left out."""
        rule_tables = {key: value for key, value in self.tables.items() if key != "files"}
        plain = json.dumps(rule_tables, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
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

        Rate, depth, encoding and channels must then equal the target's, and names end as its container does;
        everything else stays alike.
        """
        view = self.for_category(category)
        target = view.targets.get(name)
        if target is None:
            target_names = ", ".join(view.targets) or "none"
            raise SpecError(f'no target "{name}"; targets of this spec: {target_names}', where=f"targets.{name}")
        coding = target.coding
        accept = Accept(
            containers=(coding.container if coding else "wav",),
            encodings=("pcm",) if target.encoding == "flac" else (target.encoding,),
            sample_rates_hz=(target.sample_rate_hz,),
            bit_depths=None if target.is_lossy else (target.bit_depth,),
            channels=view.accept.channels if target.channels == "master" else (target.channels,),
            layouts=view.accept.layouts if target.channels == "master" else None,
            duration_s=view.accept.duration_s,
        )
        return _view(view.tables, self.folder, category=view.category, target=target, accept=accept)

    def category_of(self, path: str | Path) -> str | None:
        """Return the category that `[files]` gives to a path; the last matching glob wins."""
        from audio_checks.spec.globs import matches

        matched_category = None
        for glob, category in self.tables.get("files", {}).items():
            if matches(glob, path, self.folder):
                matched_category = category
        return matched_category

    def to_toml(self) -> str:
        """Return the spec as TOML that reads back to the same spec."""
        return to_toml(self.tables)


def parse_spec(text: str, *, where: str = "spec.toml") -> DeliverySpec:
    """Return the spec that a TOML text says.

    Raises
    ------
    SpecError
        The text is not TOML, or not a spec: its place is dotted, as in `spec.toml: limits.true_peak_dbtp`.
    """
    tables = read_tables(text, where)
    if "extend" in tables:
        raise SpecError("a spec that extends another must be read from its file", where=f"{where}: extend")
    for naming_path, naming in namings(tables):
        if "ucs_list" in naming:
            raise SpecError(
                "a spec that names a file must be read from its own; here, write the ids as ucs_ids",
                where=f"{where}: {naming_path}.ucs_list",
            )
    return _spec(tables, None, where, text)


def load_spec(path: str | Path) -> DeliverySpec:
    """Return the spec of a file: a spec, an audio-checks.toml, or the table of a pyproject.toml.

    Raises
    ------
    SpecError
        The file cannot be read, or what it says, or what it extends, is not a spec.
    """
    path = Path(path)
    inside = "tool.audio-checks" if path.name == "pyproject.toml" else ""
    return _spec(load_tables(path, ()), path.absolute().parent, str(path), read_text(path), inside)


def schema() -> dict[str, Any]:
    """Return the JSON Schema of a delivery spec."""
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Delivery spec of audio-checks, format 1",
        **spec_keys.SPEC.schema(),
    }


def _category_tables(tables: Tables, name: str) -> Tables:
    base = {key: value for key, value in tables.items() if key not in ("categories", "files")}
    category_table = tables.get("categories", {}).get(name, {})
    return merged(base, category_table)


def _spec(tables: Tables, folder: Path | None, where: str, text: str, inside: str = "") -> DeliverySpec:
    """Return the spec of whole tables, once every view of it is known to hold.

    `text` is what they were read from, where lines are looked up, and `inside` the table of it that they are.
    """
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
                raise placed(error, f"categories.{name}", ".") from None
            if len(warnings) < MOST_WARNINGS:
                view_warnings = _warnings_of(view, f"{name}: ")
                warnings += (warning for warning in view_warnings if warning.removeprefix(f"{name}: ") not in warnings)
    except SpecError as error:
        raise placed(with_lines(error, text, inside=inside), where) from None
    return _view(tables, folder, warnings=tuple(warnings[:MOST_WARNINGS]))


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
        accept=accept or read_accept(tables.get("accept", {})),
        limits=read_limits(tables.get("limits", {})),
        naming=_naming(tables, target),
        required_metadata=tuple(stated(tables.get("metadata", {})).get("required", ())),
        engine=Engine(adds=tuple(tables.get("engine", {}).get("adds", ()))),
        targets=each_read(tables.get("targets", {}), read_target),
        checks=checks,
        categories=tuple(tables.get("categories", ())),
        warnings=warnings,
    )


def _naming(tables: Tables, target: Target | None) -> Naming:
    naming = read_naming(tables.get("naming", {}))
    if target is None or target.coding is None or naming.extension is None:
        return naming
    return replace(naming, extension=target.coding.ending)


def _warnings_of(spec: DeliverySpec, prefix: str) -> list[str]:
    rates = spec.accept.sample_rates_hz or ()
    low = (
        f"{prefix}accepts {rate} Hz, but target {target.name} is {target.sample_rate_hz} Hz: "
        "nothing is ever converted up, so its render of such a master will be refused"
        for target in spec.targets.values()
        for rate in rates
        if rate < target.sample_rate_hz
    )
    many = max(spec.accept.channels or (0,))
    crowded = (
        f"{prefix}accepts {many} channels, but target {target.name} is {target.coding.label} of "
        f"{target.coding.most_channels} channels at most: its render of such a master will be refused"
        for target in spec.targets.values()
        if target.coding is not None and target.channels == "master" and many > target.coding.most_channels
    )
    texts = list(islice(chain(low, crowded), MOST_WARNINGS))
    extension = spec.naming.extension
    if extension is not None and not re.fullmatch(r"\.[A-Za-z0-9]+", extension):
        texts.append(f'{prefix}naming.extension "{extension}" is not an ending such as ".wav"')
    return texts
