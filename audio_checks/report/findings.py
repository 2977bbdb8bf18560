"""A check's finding, one file's report, and the report over many: the JSON that others read."""

import json
import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal, Self

from audio_checks.spec.check_names import Severity

Verdict = Literal["conforming", "rejected", "unreadable", "unjudged"]
VERDICTS: tuple[Verdict, ...] = ("conforming", "rejected", "unreadable", "unjudged")
SCHEMA_VERSION = 1


@dataclass(frozen=True)
class Finding:
    """One rule that a file breaks, with its proof.

    Parameters
    ----------
    code : str
        Always means the same condition, as in "true-peak:over"; the check's name comes before the colon.
    message : str
        The figure first, then the limit.
    fix : str
        What to do about it.
    severity : {"error", "warning", "information"} or None
        A check may set it for a condition that is milder or more severe than its others; the runner
        gives every other finding its severity. Information asks for an ear, and no spec raises it.
    measured, limit : float or None
        In `unit`; -inf (digital silence) is null in JSON.
    start_s, end_s : float or None
        Where in the sound.
    waived : bool
        The approver has waived it: it stays, and does not count for the exit code.
    """

    code: str
    message: str
    fix: str
    severity: Severity | None = None
    measured: float | None = None
    limit: float | None = None
    unit: str | None = None
    start_s: float | None = None
    end_s: float | None = None
    waived: bool = False

    @property
    def check(self) -> str:
        """The name of the check that found it."""
        return self.code.partition(":")[0]

    @property
    def sentence(self) -> str:
        """The message, and where in the sound it was found."""
        if self.start_s is None:
            return self.message
        if self.end_s is None or self.end_s - self.start_s < 0.0005:
            return f"{self.message}, at {self.start_s:.3f} s"
        return f"{self.message}, at {self.start_s:.3f} to {self.end_s:.3f} s"

    def to_dict(self) -> dict[str, Any]:
        """Return the finding as the report has it."""
        document = {
            "check": self.check,
            "code": self.code,
            "severity": self.severity,
            "message": self.message,
            "fix": self.fix,
            "measured": _plain(self.measured),
            "limit": _plain(self.limit),
            "unit": self.unit,
            "start_s": _plain(self.start_s),
            "end_s": _plain(self.end_s),
        }
        return {**document, "waived": True} if self.waived else document

    @classmethod
    def from_dict(cls, found: Mapping[str, Any]) -> Self:
        """Return the finding that a report holds."""
        return cls(**{key: value for key, value in found.items() if key in _FINDING_FIELDS})


_FINDING_FIELDS = frozenset(Finding.__dataclass_fields__)


@dataclass(frozen=True)
class Unjudged:
    """A check that could not judge a file because the tool failed; the rest of the report holds.

    Attributes
    ----------
    check : str
        Its name; the name of a judgement that no check reads, or "audio-checks" where the whole file failed.
    figures : tuple of str
        The measurements that failed, None in the report; empty where the check or judgement itself failed.
    message : str
        The type of the error, and what it says.
    """

    check: str
    figures: tuple[str, ...]
    message: str

    def to_dict(self) -> dict[str, Any]:
        """Return the entry as the report has it."""
        return {"check": self.check, "figures": list(self.figures), "message": self.message}

    @classmethod
    def from_dict(cls, entry: Mapping[str, Any]) -> Self:
        """Return the entry that a report holds."""
        return cls(entry["check"], tuple(entry["figures"]), entry["message"])


@dataclass(frozen=True)
class FileReport:
    """All that is said of one file.

    Facts are None when the file cannot be read; measurements hold the figures that were asked for. By
    `likeness_print` nearly equal sounds are known; see `measure.likeness`. `loudness_presets` is information
    on whole mixes, by preset. `unjudged` names the checks that failed; it is empty unless the tool has a bug.
    """

    path: str
    verdict: Verdict
    sha256: str | None = None
    pcm_sha256: str | None = None
    category: str | None = None
    facts: dict[str, Any] | None = None
    measurements: dict[str, Any] = field(default_factory=dict)
    judgements: dict[str, Any] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    likeness_print: str | None = None
    loudness_presets: dict[str, Any] = field(default_factory=dict)
    unjudged: tuple[Unjudged, ...] = ()

    def count(self, severity: Severity, *, waived: bool | None = None) -> int:
        """Return the number of findings of one severity; of those waived, or those not, when asked."""
        return sum(finding.severity == severity and waived in (None, finding.waived) for finding in self.findings)

    def to_dict(self) -> dict[str, Any]:
        """Return the file's entry in the report."""
        return {
            "path": self.path,
            "sha256": self.sha256,
            "pcm_sha256": self.pcm_sha256,
            "category": self.category,
            "verdict": self.verdict,
            "facts": _plain(self.facts),
            "measurements": _plain(self.measurements),
            "judgements": _plain(self.judgements),
            "findings": [finding.to_dict() for finding in self.findings],
            **({"likeness_print": self.likeness_print} if self.likeness_print else {}),
            **({"loudness_presets": _plain(self.loudness_presets)} if self.loudness_presets else {}),
            **({"unjudged": [failed.to_dict() for failed in self.unjudged]} if self.unjudged else {}),
        }

    def to_measured(self) -> dict[str, Any]:
        """Return the entry as `measure` prints it: no verdict, no findings."""
        return {key: value for key, value in self.to_dict().items() if key not in ("verdict", "findings")}

    @classmethod
    def from_dict(cls, entry: Mapping[str, Any]) -> Self:
        """Return the entry that a report holds; a figure that was -inf comes back as None."""
        facts = {key: value for key, value in entry.items() if key in _FILE_FIELDS}
        findings = tuple(Finding.from_dict(finding) for finding in entry.get("findings", ()))
        unjudged = tuple(Unjudged.from_dict(failed) for failed in entry.get("unjudged", ()))
        return cls(**{**facts, "findings": findings, "unjudged": unjudged})


_FILE_FIELDS = frozenset(FileReport.__dataclass_fields__)


@dataclass(frozen=True)
class SpecRef:
    """The spec that a report was judged by."""

    name: str
    sha256: str


@dataclass(frozen=True)
class Report:
    """The report on many files.

    `specs` holds the one spec they were judged by; none when there was none, several when each folder has its own.
    """

    files: tuple[FileReport, ...]
    specs: tuple[SpecRef, ...] = ()
    not_run: tuple[str, ...] = ()
    tool_version: str = ""

    @property
    def summary(self) -> dict[str, int]:
        """The counts of files by verdict, and of findings by severity; waived findings are counted in both."""
        verdicts = Counter(entry.verdict for entry in self.files)
        return {
            "files": len(self.files),
            **{verdict: verdicts[verdict] for verdict in VERDICTS},
            "errors": sum(entry.count("error") for entry in self.files),
            "warnings": sum(entry.count("warning") for entry in self.files),
            "waived": sum(finding.waived for entry in self.files for finding in entry.findings),
        }

    def to_dict(self) -> dict[str, Any]:
        """Return the report as its JSON has it."""
        specs = [{"name": spec.name, "sha256": spec.sha256} for spec in self.specs]
        return {
            "schema_version": SCHEMA_VERSION,
            "tool": {"name": "audio-checks", "version": self.tool_version},
            "spec": specs[0] if len(specs) == 1 else None,
            **({"specs": specs} if len(specs) > 1 else {}),
            "files": [entry.to_dict() for entry in self.files],
            "summary": self.summary,
            "not_run": list(self.not_run),
        }

    @classmethod
    def from_dict(cls, report: Mapping[str, Any]) -> Self:
        """Return the report that a JSON document holds.

        Raises
        ------
        ValueError
            The document is of another schema version, or no report.
        """
        if report.get("schema_version") != SCHEMA_VERSION:
            raise ValueError(f"not a report of schema version {SCHEMA_VERSION}")
        specs = report.get("specs") or ([report["spec"]] if report.get("spec") else [])
        try:
            return cls(
                files=tuple(FileReport.from_dict(entry) for entry in report["files"]),
                specs=tuple(SpecRef(name=spec["name"], sha256=spec["sha256"]) for spec in specs),
                not_run=tuple(report.get("not_run", ())),
                tool_version=report["tool"]["version"],
            )
        except (KeyError, TypeError, AttributeError) as error:
            raise ValueError(f"not a report: {error}") from None


def with_waivers(entry: FileReport, waived: Mapping[str, frozenset[str]]) -> FileReport:
    """Return the entry with the findings marked whose codes are waived for its sound; its verdict stays."""
    codes = waived.get(entry.pcm_sha256 or entry.sha256 or "", frozenset())
    if not codes:
        return entry
    return replace(
        entry,
        findings=tuple(
            replace(finding, waived=True) if finding.code in codes else finding for finding in entry.findings
        ),
    )


def dumps(value: object, *, indent: int | None = None) -> str:
    """Return JSON in which no control character and no lone surrogate stands raw."""
    return json.dumps(value, indent=indent, allow_nan=False).replace("\x7f", "\\u007f")


def printable(text: str) -> str:
    r"""Return text that is safe to print on one line: what does not print is shown escaped, as in `\n` or `\u202e`."""
    if text.isprintable():
        return text
    return "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode("ascii")
        for character in text
    )


def _plain(value: Any) -> Any:
    """Return the value as JSON can hold it: -inf, and anything else that is not a number, is null."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {key: _plain(member) for key, member in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(member) for member in value]
    return value


def _nullable(kind: str) -> dict[str, Any]:
    return {"type": [kind, "null"]}


def schema() -> dict[str, Any]:
    """Return the JSON Schema of the report."""
    finding = {
        "type": "object",
        "required": ["check", "code", "severity", "message", "fix", "measured", "limit", "unit", "start_s", "end_s"],
        "properties": {
            "check": {"type": "string"},
            "code": {"type": "string", "pattern": "^[a-z-]+:[a-z0-9-]+$"},
            "severity": {"enum": ["error", "warning", "information"]},
            "message": {"type": "string"},
            "fix": {"type": "string"},
            "measured": _nullable("number"),
            "limit": _nullable("number"),
            "unit": _nullable("string"),
            "start_s": _nullable("number"),
            "end_s": _nullable("number"),
            "waived": {"type": "boolean"},
        },
    }
    facts = {
        "type": ["object", "null"],
        "properties": {
            "container": {"type": "string"},
            "encoding": {"enum": ["pcm", "float", "vorbis", "opus", "mp3"]},
            "sample_rate_hz": {"type": "integer"},
            "bit_depth": {"type": "integer"},
            "effective_bits": _nullable("integer"),
            "channels": {"type": "integer"},
            "frames": {"type": "integer"},
            "duration_s": {"type": "number"},
            "chunks": {"type": "array", "items": {"type": "string"}},
            "bit_rate_kbps": {"type": "number"},
        },
    }
    unjudged = {
        "type": "object",
        "required": ["check", "figures", "message"],
        "properties": {
            "check": {"type": "string"},
            "figures": {"type": "array", "items": {"type": "string"}},
            "message": {"type": "string"},
        },
    }
    entry = {
        "type": "object",
        "required": ["path", "sha256", "pcm_sha256", "category", "verdict", "facts", "measurements", "findings"],
        "properties": {
            "path": {"type": "string"},
            "sha256": _nullable("string"),
            "pcm_sha256": _nullable("string"),
            "category": _nullable("string"),
            "verdict": {"enum": list(VERDICTS)},
            "facts": facts,
            "measurements": {"type": "object"},
            "judgements": {"type": "object"},
            "findings": {"type": "array", "items": finding},
            "likeness_print": {"type": "string"},
            "loudness_presets": {"type": "object"},
            "unjudged": {"type": "array", "items": unjudged},
        },
    }
    spec = {
        "type": "object",
        "required": ["name", "sha256"],
        "properties": {"name": {"type": "string"}, "sha256": {"type": "string"}},
    }
    counts = ["files", *VERDICTS, "errors", "warnings"]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Report of audio-checks, schema version 1",
        "type": "object",
        "required": ["schema_version", "tool", "spec", "files", "summary"],
        "properties": {
            "schema_version": {"const": SCHEMA_VERSION},
            "tool": spec | {"required": ["name", "version"], "properties": {"name": {}, "version": {"type": "string"}}},
            "spec": {"anyOf": [spec, {"type": "null"}]},
            "specs": {"type": "array", "items": spec},
            "files": {"type": "array", "items": entry},
            "summary": {
                "type": "object",
                "required": counts,
                "properties": {key: {"type": "integer", "minimum": 0} for key in [*counts, "waived"]},
            },
            "not_run": {"type": "array", "items": {"type": "string"}},
        },
    }


def lowering_advice(excess_db: float, *, is_cut_off: bool) -> str:
    """Return the remedy for a peak over its limit, by the fate of the tops."""
    lower = f"lower the level by {excess_db:.2f} dB"
    if not is_cut_off:
        return f"{lower} or more"
    return (
        "its tops are cut off flat, and a lower level leaves them so: lower the gain before the stage that clips, and "
        f"export again; only if the flat tops are meant, {lower}"
    )


def level_shown(level: float) -> str:
    """Return a limit in decibels as the spec states it, with one decimal at least: −1 reads -1.0, −0.15 stays."""
    text = f"{level:g}"
    return text if "." in text or "e" in text else f"{text}.0"
