"""The desk as a page in one file: no script, nothing from outside, and every word of a server as text."""

import os
import sys
import tempfile
from collections.abc import Sequence
from datetime import datetime
from html import escape
from pathlib import Path
from typing import NamedTuple

from app.client.terminal import counted, shown

FILE_NAME = "desk.html"
NAME_AT = 2  # the column that leads to the page
STYLE = """
:root{color-scheme:light dark;--paper:#fff;--ink:#131514;--quiet:#5c605a;--line:#dadcd6;--late:#a3241a;--link:#0b57a4}
@media(prefers-color-scheme:dark){
:root{--paper:#141617;--ink:#eceeea;--quiet:#a3a8a1;--line:#33383a;--late:#ff9d8f;--link:#8cc2ff}}
body{margin:0 auto;max-width:1200px;padding:24px;background:var(--paper);color:var(--ink);
font:16px/1.5 system-ui,sans-serif}
h1{margin:0;font-size:1.5rem}
p{margin:4px 0 16px}
.quiet{color:var(--quiet)}
table{width:100%;border-collapse:collapse}
th,td{padding:8px 12px 8px 0;border-bottom:1px solid var(--line);text-align:left;vertical-align:top}
td:nth-child(-n+2){white-space:nowrap}
td:nth-child(n+3){overflow-wrap:break-word}
td:nth-child(3),td:last-child{overflow-wrap:anywhere}
th{color:var(--quiet);font-weight:normal}
.late{color:var(--late);font-weight:600}
a{color:var(--link)}
a:focus-visible{outline:3px solid currentColor;outline-offset:2px}
@media(max-width:800px){
body{padding:16px}
thead{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
table,tbody,tr,td{display:block}
tr{padding:12px 0;border-bottom:1px solid var(--line)}
td{padding:0;border:0;overflow-wrap:anywhere}
td:empty{display:none}
td::before{color:var(--quiet);content:attr(data-head) ": "}}
"""
# Should a word ever be taken for markup, the browser still runs, loads and sends nothing.
POLICY = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'"


class Line(NamedTuple):
    """A cue that is owed: a text for each column, where its page is, and whether its day has passed."""

    texts: Sequence[str]
    page: str
    is_late: bool


def html_of(heads: Sequence[str], lines: Sequence[Line], remarks: Sequence[str], written_at: datetime) -> str:
    """Return the page; remarks name servers that did not answer, or not in full."""
    items = "".join(f"<li>{_text(remark)}</li>" for remark in remarks)
    count = counted(len(lines), "cue")
    if lines:
        head = "".join(f'<th scope="col">{_text(head_text)}</th>' for head_text in heads)
        rows = "\n".join(_row(heads, line) for line in lines)
        body = f"<table><thead><tr>{head}</tr></thead><tbody>\n{rows}\n</tbody></table>"
    else:
        body = "<p>Nothing is owed.</p>" if not remarks else "<p>No server that answered has anything owed.</p>"
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="referrer" content="no-referrer">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>What you owe</title>
<style>{STYLE}</style>
</head>
<body>
<main>
<h1>What you owe</h1>
<p class="quiet">{count}, what is due soonest first. Written on {written_at:%Y-%m-%d at %H:%M}.
For what is new: soundlist desk --page</p>
{f'<section aria-label="Not in full"><ul>{items}</ul></section>' if items else ""}
{body}
</main>
</body>
</html>
"""


def _row(heads: Sequence[str], line: Line) -> str:
    cells = []
    for column, (head, text) in enumerate(zip(heads, line.texts, strict=True)):
        shown_text = _text(text)
        if column == NAME_AT:
            shown_text = f'<a href="{escape(line.page)}" rel="noopener noreferrer">{shown_text or "open"}</a>'
        late = ' class="late"' if column == 0 and line.is_late else ""
        cells.append(f'<td data-head="{_text(head)}"{late}>{shown_text}</td>')
    return f"<tr>{''.join(cells)}</tr>"


def _text(text: str) -> str:
    return escape(shown(text))


def cache_path() -> Path:
    """Return the place of the page: the user's folder for data that can be made again."""
    home = Path.home()
    if os.name == "nt":
        folder = Path(os.environ.get("LOCALAPPDATA") or home / "AppData" / "Local")
    elif sys.platform == "darwin":
        folder = home / "Library" / "Caches"
    else:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or home / ".cache")
    return folder / "soundlist" / FILE_NAME


def write_page(path: Path, html: str) -> None:
    """Write the page for its owner alone; what was there stays until the new one is whole."""
    handle, beside = tempfile.mkstemp(prefix=f".{path.name}-", dir=path.parent)  # mode 0600
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(html)
        Path(beside).replace(path)
    except BaseException:
        Path(beside).unlink(missing_ok=True)
        raise
