"""What the wheel of the server needs besides pyproject.toml: the library of its own version, and a built page."""

from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface


class SameVersion(MetadataHookInterface):
    """Asks for audio-checks of the server's own version: both are made from one tag, and are tested together."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Pin the library."""
        pin = f"audio-checks=={metadata['version']}"
        metadata["dependencies"] = [pin if name == "audio-checks" else name for name in metadata["dependencies"]]


class BuiltPage(BuildHookInterface):  # type: ignore[type-arg]
    """Refuses to build a server without its page."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:  # noqa: ARG002 - hatchling's interface
        """Look for the page and the guides, except for an editable installation."""
        for part in ("index.html", "help/index.html"):
            page = Path(self.root, "../../frontend/dist", part).resolve()
            if version == "standard" and not page.exists():
                raise SystemExit(f"the page is not built ({page} is missing); build it first: make setup")
