"""A handover pack's content: one page to read, and the cues as a table; nothing of money, hours or reasons."""

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass, field, fields

from app.sound_lists.rules import spreadsheet_safe


@dataclass(frozen=True)
class ArchivedFile:
    """One approved master in the pack, or the reason why it is not in it."""

    path: str
    sha256: str
    version: int | None
    sources: str
    left_out: str = ""
    plug_ins: Sequence[str] = ()
    recipe: str = ""
    source_files: Sequence[str] = ()  # paths in the pack


@dataclass(frozen=True)
class ArchivedRemark:
    """A request of a cue in review, or a remark on it."""

    file_name: str
    at_s: float | None
    by: str
    on: str  # the day
    text: str
    is_request: bool  # a change request; else a comment


@dataclass(frozen=True)
class ArchivedCue:
    """One cue of the contract, and how far the work on it was."""

    label: str
    name: str
    category: str
    description: str
    variations: int
    is_palette: bool
    state: str
    files: Sequence[ArchivedFile] = ()
    owed: Sequence[str] = ()  # names of files that have no approved version
    remarks: Sequence[ArchivedRemark] = ()
    questions: Sequence[str] = ()


@dataclass(frozen=True)
class Handover:
    """All that a handover pack says."""

    project: str
    contract: str
    cues: Sequence[ArchivedCue]
    palette: Sequence[ArchivedFile] = ()  # of other contracts
    brief: Sequence[tuple[str, str]] = ()  # question and answer
    open_brief: Sequence[str] = ()  # questions of the brief without an answer


@dataclass(frozen=True)
class CueRow:
    """One row of the table: a file of a cue."""

    cue: str
    name: str
    category: str
    description: str
    state: str
    palette: str
    file: str
    version: int | None = None
    sha256: str = ""
    sources: str = ""
    note: str = ""

    @property
    def cells(self) -> list[str | int | None]:
        """The row's cells, none of which a spreadsheet takes for a formula."""
        values = [getattr(self, column.name) for column in fields(self)]
        return [spreadsheet_safe(value) if isinstance(value, str) else value for value in values]


def cue_table(handover: Handover) -> bytes:
    """Return the cues of a handover as CSV, one row a file, those owed included."""
    out = io.StringIO(newline="")
    writer = csv.writer(out)
    writer.writerow([column.name for column in fields(CueRow)])
    writer.writerows(row.cells for cue in handover.cues for row in _rows(cue))
    return ("\ufeff" + out.getvalue()).encode()


def _rows(cue: ArchivedCue) -> list[CueRow]:
    facts = (cue.label, cue.name, cue.category, cue.description, cue.state, "yes" if cue.is_palette else "no")
    rows = [CueRow(*facts, file.path, file.version, file.sha256, file.sources, file.left_out) for file in cue.files]
    return rows + [CueRow(*facts, name, note="no approved version yet") for name in cue.owed]


@dataclass
class _Page:
    lines: list[str] = field(default_factory=list)

    def section(self, title: str, lines: Sequence[str], otherwise: str) -> None:
        self.lines += [f"## {title}", "", *(lines or [otherwise]), ""]


def read_me(handover: Handover) -> bytes:
    """Return the page that the next designer begins with, in Markdown."""
    cues = handover.cues
    files = [file for cue in cues for file in cue.files]
    page = _Page([f"# Handover of {handover.contract}, {handover.project}", ""])
    page.section("Cues", [_cue_line(cue) for cue in cues], "The contract covered no cue.")
    page.section(
        "Approved files", [_file_line(file) for file in files], "No cue of the contract has an approved version."
    )
    banks = [line for file in files for line in _bank_lines(file)]
    page.section("Source files", banks, "No approved file has source files that the contract hands over.")
    owed = [f"- {name} ({cue.label} {cue.name})" for cue in cues for name in cue.owed]
    page.section("Files still to deliver", owed, "None: every variation has its approved version.")
    remarks = [line for cue in cues if cue.remarks for line in _remark_lines(cue)]
    page.section("Open rounds", remarks, "No cue without an approved version has a change request or an open comment.")
    questions = [f"- {cue.label} {cue.name}: {text}" for cue in cues for text in cue.questions]
    page.section("Open questions", questions, "No question on these cues is open.")
    page.section("Palette of other contracts", [_file_line(file) for file in handover.palette], "None.")
    brief = [line for question, answer in handover.brief for line in (f"### {question}", "", answer, "")]
    page.section("Brief", brief, "The project has no brief.")
    if handover.open_brief:
        page.section("Open points of the brief", [f"- {text}" for text in handover.open_brief], "")
    return "\n".join(page.lines).encode()


def _cue_line(cue: ArchivedCue) -> str:
    palette = ", palette" if cue.is_palette else ""
    return f"- {cue.label} {cue.name}: {cue.state}{palette}"


def _file_line(file: ArchivedFile) -> str:
    left_out = f", not in this pack: {file.left_out}" if file.left_out else ""
    return f"- {file.path}, SHA-256 {file.sha256}; {file.sources or 'sources not stated'}{left_out}"


def _bank_lines(file: ArchivedFile) -> list[str]:
    if not (file.plug_ins or file.recipe or file.source_files):
        return []
    plug_ins = [f"- Plug-ins: {', '.join(file.plug_ins)}"] if file.plug_ins else []
    return [f"### {file.path}", "", *(f"- {path}" for path in file.source_files), *plug_ins, "", file.recipe, ""]


def _remark_lines(cue: ArchivedCue) -> list[str]:
    lines = [f"### {cue.label} {cue.name}", ""]
    for remark in cue.remarks:
        at = "" if remark.at_s is None else f" at {remark.at_s:.2f} s"
        kind = "Change requested" if remark.is_request else "Comment"
        lines.append(f"- {kind}, {remark.file_name}{at}, {remark.by}, {remark.on}: {' '.join(remark.text.split())}")
    return [*lines, ""]
