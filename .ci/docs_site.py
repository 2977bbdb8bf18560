"""Build the guides as a site for /help: python .ci/docs_site.py [--to FOLDER].

The server's content security policy admits no script inside a page, so each is moved to a file.
"""

import argparse
import hashlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
GUIDES, COPY, BUILT = ROOT / "docs", ROOT / ".make" / "guides", ROOT / ".make" / "help-site"  # as zensical.toml says
LINK = re.compile(r"(?<!!)\[([^]]+)\]\(((?:\.\./)+[^)#\s]+)(?:#[^)\s]*)?\)")
SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)


def copy_guides() -> None:
    """Copy the guides; a link to a file of the repository that is no guide becomes its name."""
    shutil.rmtree(COPY, ignore_errors=True)
    shutil.copytree(GUIDES, COPY)
    for page in GUIDES.rglob("*.md"):

        def without_outside(link: re.Match[str], page: Path = page) -> str:
            target = Path(os.path.normpath(page.parent / link[2]))
            return link[0] if target.is_relative_to(GUIDES) else link[1]

        text = LINK.sub(without_outside, page.read_text(encoding="utf-8"))
        (COPY / page.relative_to(GUIDES)).write_text(text, encoding="utf-8")


def move_scripts() -> None:
    """Move each script inside a page to a file beside the others."""
    scripts = BUILT / "assets" / "javascripts"
    for page in BUILT.rglob("*.html"):
        to_scripts = os.path.relpath(scripts, page.parent)

        def as_file(script: re.Match[str], to_scripts: str = to_scripts) -> str:
            name = f"inline.{hashlib.sha256(script[1].encode()).hexdigest()[:8]}.js"
            (scripts / name).write_text(script[1], encoding="utf-8")
            return f'<script src="{to_scripts}/{name}"></script>'

        page.write_text(SCRIPT.sub(as_file, page.read_text(encoding="utf-8")), encoding="utf-8")


def main() -> int:
    """Build, and put the site where the server finds it."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--to", type=Path, default=ROOT / "frontend" / "dist" / "help")
    to = parser.parse_args().to
    copy_guides()
    program = Path(sys.executable).with_name("zensical")
    command = [program, "build", "--clean", "--strict"]
    built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if "caught panic" in built.stderr:  # zensical 0.0.73 was seen to miss a page that is there
        built = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if built.returncode:
        sys.stderr.write(built.stdout + built.stderr)
        return 1
    move_scripts()
    shutil.rmtree(to, ignore_errors=True)
    to.parent.mkdir(parents=True, exist_ok=True)
    shutil.move(BUILT, to)
    return 0


if __name__ == "__main__":
    sys.exit(main())
