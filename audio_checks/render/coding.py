"""A game file in a codec, from the WAV file of its sound: encoded by libsndfile in a disposable child.

The encoder gets what we have resampled, and never a stranger's bytes; but it is C, and a crash of it must not be ours.
"""

import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from audio_checks import wav
from audio_checks.audio.sandbox import Sandbox, is_inside
from audio_checks.render.flac_blocks import rewrite_flac
from audio_checks.render.ogg_pages import Comments, rewrite_ogg

CODER_VERSION = "1"  # changes when the same sound, encoding and quality give other bytes with the same libsndfile
ENCODE_S = 300.0
MOST_FILE_BYTES = 2 << 30
BLOCK_FRAMES = 4_096  # libvorbis keeps what it is given at once on its stack
FORMATS = {"vorbis": ("OGG", "VORBIS"), "opus": ("OGG", "OPUS")}
FLAC_SUBTYPES = {8: "PCM_S8", 16: "PCM_16", 24: "PCM_24"}
FLAC_LEVEL = 1.0  # the smallest files


@dataclass(frozen=True)
class Coder:
    """The encoding of files: its codec and quality (0 to 1; nothing for FLAC)."""

    encoding: str
    quality: float = 0.0

    def write(
        self,
        sound: Path,
        out: Path,
        *,
        seed: bytes,
        comments: Comments = (),
        chunks: Sequence[tuple[str, bytes]] = (),
        durable: bool = True,
    ) -> None:
        """Encode a WAV file of ours.

        Parameters
        ----------
        sound, out : path
            The WAV file, and where the coded one goes.
        seed : bytes
            Digest of the master: it numbers the stream of an Ogg file.
        comments : sequence of (name, text)
            What the file says of itself.
        chunks : sequence of (id, payload)
            What a FLAC file keeps of the WAV file.
        durable : bool
            The file is on the disk before this returns.
        """
        encoded = out.with_name(f"{out.name}.encoded")
        encoded.touch()
        try:
            if is_inside():
                encode(str(sound.absolute()), str(encoded.absolute()), self.encoding, self.quality)
            else:
                where, to = str(sound.absolute()), str(encoded.absolute())
                with _sandbox().child(reads=[where], writes=[to]) as child:
                    child.call(encode, where, to, self.encoding, self.quality)
            with encoded.open("rb") as source, out.open("wb") as target:
                if self.encoding in FORMATS:
                    serial = int.from_bytes(seed[:4], "little")
                    rewrite_ogg(source, target, encoding=self.encoding, serial=serial, comments=comments)
                else:
                    rewrite_flac(source, target, comments=comments, chunks=chunks)
                if durable:
                    target.flush()
                    os.fsync(target.fileno())
        finally:
            with suppress(FileNotFoundError):
                encoded.unlink()


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=ENCODE_S,
        file_bytes=MOST_FILE_BYTES,
        preload=("numpy", "soundfile", "audio_checks.render.coding"),
    )


def encode(path: str, out: str, encoding: str, quality: float) -> None:
    """Write the sound of a WAV file as Ogg Vorbis, Opus or FLAC. Runs in a sandbox's child."""
    import soundfile  # slow to import, and no WAV needs it

    with wav.open_regular(path) as file:
        layout = wav.read_layout(file)
        form, subtype = FORMATS[encoding] if encoding in FORMATS else ("FLAC", FLAC_SUBTYPES[layout.bit_depth])
        with soundfile.SoundFile(
            out,
            "w",
            samplerate=layout.sample_rate_hz,
            channels=layout.channels,
            format=form,
            subtype=subtype,
            compression_level=1.0 - quality if encoding in FORMATS else FLAC_LEVEL,
        ) as sound:
            for block in wav.blocks(file, layout):
                for at in range(0, len(block), BLOCK_FRAMES):
                    piece = block[at : at + BLOCK_FRAMES]
                    if encoding in FORMATS:
                        sound.write(piece.astype(np.float32))
                    else:
                        sound.write((piece * 2.0**31).astype(np.int32))  # exact: whole numbers of its upper bits
