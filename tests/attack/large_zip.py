"""A large ZIP of sounds goes through a real server and becomes takes: `make large-zip` sends 5 GiB.

Prints how long it took, and what memory and disk it used; the exit code is 1 where a limit was exceeded.
"""

import argparse
import itertools
import sys
import tempfile
import threading
import time
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast
from uuid import UUID

import numpy as np

from tests.attack.siege import private_mib, processes_below
from tests.kill.processes import Process, ProcessServer, Zygote
from tests.support.deliver import BYTES, TUS, add_cues, metadata, open_delivery
from tests.support.server import RunningServer, World

SOUND_BYTES = 64 << 20  # four minutes of 24 bit stereo at 48,000 Hz
FRAME_BYTES, SAMPLE_RATE_HZ = 6, 48_000
BLOCK_BYTES = 6 << 18
PIECE_BYTES = 16 << 20  # of an upload, as browsers send it
MAX_GROWTH_MIB = 120.0  # of the web processes together, and of the worker without the children that read sounds
DISK_TIMES = 3.2  # the ZIP, its sounds and their game files, and nothing twice
LOOK_EVERY_S = 0.2
UNPACKED_WITHIN_S = 3_600.0


@dataclass
class Passage:
    """The outcome of one ZIP."""

    zip_bytes: int
    sounds: int
    upload_s: float = 0.0
    unpack_s: float = 0.0
    taken: int = 0
    state: str = ""
    growth_mib: dict[str, float] = field(default_factory=dict)
    disk_bytes: int = 0

    @property
    def faults(self) -> list[str]:
        """Return what must not have happened."""
        faults = []
        if (self.state, self.taken) != ("unpacked", self.sounds):
            faults.append(f"the ZIP is {self.state}, and {self.taken} of {self.sounds} sounds are takes")
        faults += [
            f"memory of the {part} grew by {mib:.0f} MiB, limit {MAX_GROWTH_MIB:.0f} MiB"
            for part, mib in self.growth_mib.items()
            if mib > MAX_GROWTH_MIB
        ]
        if self.disk_bytes > DISK_TIMES * self.zip_bytes:
            faults.append(f"the disk held {self.disk_bytes:,} bytes for a ZIP of {self.zip_bytes:,} bytes")
        return faults

    def __str__(self) -> str:
        memory = ", ".join(f"{part} +{mib:.0f} MiB" for part, mib in self.growth_mib.items())
        return (
            f"ZIP of {self.zip_bytes:,} bytes, {self.sounds} sounds: uploaded in {self.upload_s:.1f} s, "
            f"unpacked in {self.unpack_s:.1f} s, {self.taken} takes; memory: {memory}; disk: {self.disk_bytes:,} bytes"
        )


def pass_through(zygote: Zygote, folder: Path, zip_bytes: int, *, sound_bytes: int = SOUND_BYTES) -> Passage:
    """Upload a ZIP of nearly this size to a new server, wait until it is unpacked, and return its outcome."""
    made = folder / "all.zip"
    sounds = write_zip(made, zip_bytes, sound_bytes)
    passage = Passage(made.stat().st_size, sounds)
    server = ProcessServer(zygote, folder)
    try:
        world = World(cast(RunningServer, server))
        parts = {"web processes": server.serve(web_processes=2), "worker": server.work()}
        add_cues(world, {"name": "Ambience", "variations": sounds})
        delivery_id = open_delivery(world)
        with _watched(passage, parts, folder / "data"):
            begun = time.monotonic()
            upload_id = _upload(world, delivery_id, made)
            passage.upload_s = time.monotonic() - begun
            _unpack(world, delivery_id, upload_id, passage)
    finally:
        server.close()
    return passage


def write_zip(path: Path, zip_bytes: int, sound_bytes: int) -> int:
    """Write a ZIP of WAV files, all different, as large as they fit into so many bytes; return how many there are."""
    noise = np.random.default_rng(1).integers(0, 256, BLOCK_BYTES, np.uint8).tobytes()
    room = zip_bytes - (1 << 20)  # for the directory
    sizes = [sound_bytes] * (room // sound_bytes)
    if (rest := room % sound_bytes) > BLOCK_BYTES:
        sizes.append(rest)
    with zipfile.ZipFile(path, "w", zipfile.ZIP_STORED) as archive:
        for number, size in enumerate(sizes, start=1):
            frames = size // FRAME_BYTES
            with archive.open(f"ambience_{number:02}.wav", "w") as entry:
                entry.write(_head(frames * FRAME_BYTES))
                entry.write(number.to_bytes(FRAME_BYTES, "little"))
                for begin in range(FRAME_BYTES, frames * FRAME_BYTES, BLOCK_BYTES):
                    entry.write(noise[: frames * FRAME_BYTES - begin])
    return len(sizes)


def _head(data_bytes: int) -> bytes:
    of_format = np.array([1, 2], "<u2").tobytes()
    of_format += np.array([SAMPLE_RATE_HZ, SAMPLE_RATE_HZ * FRAME_BYTES], "<u4").tobytes()
    of_format += np.array([FRAME_BYTES, 24], "<u2").tobytes()
    size = [np.array([number], "<u4").tobytes() for number in (36 + data_bytes, 16, data_bytes)]
    return b"RIFF" + size[0] + b"WAVEfmt " + size[1] + of_format + b"data" + size[2]


def _upload(world: World, delivery_id: str, made: Path) -> UUID:
    size = made.stat().st_size
    names = metadata(delivery_id=delivery_id, file_name="all.zip")
    begun = world.designer.post("/v1/uploads", headers=TUS | {"Upload-Length": str(size), "Upload-Metadata": names})
    assert begun.status_code == 201, begun.text
    place = begun.headers["Location"]
    with made.open("rb") as file:
        for offset in itertools.count(0, PIECE_BYTES):
            if not (piece := file.read(PIECE_BYTES)):
                break
            headers = TUS | BYTES | {"Upload-Offset": str(offset)}
            sent: Any = world.designer.patch(place, content=piece, headers=headers, timeout=UNPACKED_WITHIN_S)
            assert sent.status_code == 204, sent.text
    return UUID(place.rpartition("/")[2])


def _unpack(world: World, delivery_id: str, upload_id: UUID, passage: Passage) -> None:
    begun = time.monotonic()
    body = {"upload_id": str(upload_id), "file_name": "all.zip"}
    asked = world.designer.post(f"/v1/deliveries/{delivery_id}/archives", json=body)
    assert asked.status_code == 201, asked.text
    while (passed_s := time.monotonic() - begun) < UNPACKED_WITHIN_S:
        (archive,) = world.designer.get(f"/v1/deliveries/{delivery_id}").json()["archives"]
        if archive["state"] != "received":
            passage.state, passage.unpack_s = archive["state"], passed_s
            passage.taken = sum(entry["take_id"] is not None for entry in archive["entries"])
            return
        time.sleep(LOOK_EVERY_S)


@contextmanager
def _watched(passage: Passage, parts: dict[str, Process], data: Path) -> Iterator[None]:
    """Note the most memory and disk that is used as long as the block lasts."""
    before = {part: _mib(part, process.pid) for part, process in parts.items()}
    over = threading.Event()

    def look() -> None:
        while not over.wait(LOOK_EVERY_S):
            for part, process in parts.items():
                grown = _mib(part, process.pid) - before[part]
                passage.growth_mib[part] = max(passage.growth_mib.get(part, 0.0), grown)
            passage.disk_bytes = max(passage.disk_bytes, _disk_bytes(data))

    looking = threading.Thread(target=look, name="memory and disk")
    looking.start()
    try:
        yield
    finally:
        over.set()
        looking.join()


def _mib(part: str, pid: int) -> float:
    """Return the memory of the web processes, or of the worker, whose children are bounded by the sandbox."""
    return private_mib(pid) if part == "worker" else sum(map(private_mib, processes_below(pid)))


def _disk_bytes(folder: Path) -> int:
    """Return what the files take on disk; a file with two names counts once."""
    found = {}
    for path in folder.rglob("*"):
        try:
            status = path.stat()
        except OSError:
            continue
        found[status.st_ino] = 512 * status.st_blocks
    return sum(found.values())


def main() -> int:
    """Send a ZIP, print the outcome, and return how many limits it exceeded."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bytes", type=int, default=5 << 30)
    asked = parser.parse_args()
    zygote = Zygote()
    try:
        with tempfile.TemporaryDirectory(prefix="soundlist-zip-") as folder:
            passage = pass_through(zygote, Path(folder), asked.bytes)
    finally:
        zygote.close()
    sys.stdout.write(f"{passage}\n")
    sys.stdout.writelines(f"FAILED {fault}\n" for fault in passage.faults)
    return len(passage.faults)


if __name__ == "__main__":
    sys.exit(main())
