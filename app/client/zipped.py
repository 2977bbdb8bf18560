"""A ZIP of shipped sounds, unpacked into a folder for a while; nothing outside of it is written."""

import zipfile
import zlib
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from app.client.errors import Refusal
from app.client.paths import ensure_distinct, ensure_harmless

MAX_BYTES = 32 << 30  # of all sounds in a ZIP
BLOCK_BYTES = 1 << 20


@contextmanager
def unpacked(archive: Path, endings: Collection[str], most: int) -> Iterator[Path]:
    """Give a folder with the sounds of a ZIP; hidden files are left out. Raise Refusal for a ZIP that is harmful."""
    with TemporaryDirectory(prefix="soundlist-") as temporary:
        root = Path(temporary, archive.stem or "Sounds")
        root.mkdir()
        try:
            with zipfile.ZipFile(archive) as opened:
                _unpack(opened, _sounds(opened, endings), root, most)
        except (zipfile.BadZipFile, NotImplementedError, EOFError, RuntimeError, zlib.error) as error:
            raise Refusal(f"{archive} cannot be unpacked: {error}; unpack it yourself, and adopt the folder") from None
        yield root


def _sounds(opened: zipfile.ZipFile, endings: Collection[str]) -> list[zipfile.ZipInfo]:
    return [
        entry
        for entry in opened.infolist()
        if not entry.is_dir()
        and not any(part.startswith((".", "__MACOSX")) and part != ".." for part in entry.filename.split("/"))
        and Path(entry.filename).suffix.lower() in endings
    ]


def _unpack(opened: zipfile.ZipFile, entries: list[zipfile.ZipInfo], root: Path, most: int) -> None:
    if len(entries) > most:
        raise Refusal(f"the ZIP holds {len(entries):,} sounds; adopt at most {most:,} at once, in several ZIPs")
    total = sum(entry.file_size for entry in entries)
    if total > MAX_BYTES:
        raise Refusal(f"the ZIP unpacks to {total >> 30} GiB; unpack it yourself, and adopt its folders one by one")
    ensure_distinct(ensure_harmless(entry.filename) for entry in entries)
    for entry in entries:
        out_path = root.joinpath(*entry.filename.split("/"))
        out_path.parent.mkdir(parents=True, exist_ok=True)
        with opened.open(entry) as source, out_path.open("wb") as target:  # stops at the size that was announced
            while block := source.read(BLOCK_BYTES):
                target.write(block)
