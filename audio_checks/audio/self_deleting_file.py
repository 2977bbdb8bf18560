"""A file that lives as long as it is read."""

from __future__ import annotations

import io
import os
from contextlib import suppress


class SelfDeletingFile(io.FileIO):
    """A file that is removed with its last use: at once where the system can, else when it is closed."""

    def __init__(self, path: str) -> None:
        super().__init__(path, "rb")
        self._path: str | None = path
        if os.name == "posix":
            self._remove()

    def close(self) -> None:
        """Close the file, and make sure that it is deleted."""
        super().close()
        self._remove()

    def _remove(self) -> None:
        path, self._path = getattr(self, "_path", None), None
        if path is not None:
            with suppress(FileNotFoundError):
                os.unlink(path)
