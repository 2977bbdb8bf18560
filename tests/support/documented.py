"""The commands that pages of docs tell an operator to type, read from the pages themselves."""

import re
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = ("how-to/operate", "how-to/accounts")
BLOCK = re.compile(r"^ *```(\w*)\n(.*?)^ *```$", re.DOTALL | re.MULTILINE)
SHELLS = ("", "sh", "shell", "bash", "console")
COMMENT = re.compile(r"\s{2,}#.*$")
SETTING = re.compile(r"[A-Z_]+=")


def documented_commands() -> list[str]:
    """Return the commands of all pages; a line that joins some by `&&` gives each of them."""
    commands: list[str] = []
    for page in PAGES:
        for language, block in BLOCK.findall((DOCS / f"{page}.md").read_text()):
            if language not in SHELLS:
                continue
            lines = (COMMENT.sub("", line).strip() for line in block.splitlines())
            commands += [
                command.strip() for line in lines if line and not SETTING.match(line) for command in line.split("&&")
            ]
    return commands
