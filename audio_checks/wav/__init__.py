"""WAV files of strangers (RIFF and RF64): a strict reader, decoding in blocks, and a writer."""

from audio_checks.wav.decoding import BLOCK_FRAMES, Decoder, blocks, decode, decode_to, frames_at_once, raw_blocks
from audio_checks.wav.files import chunk_payload, fill, open_regular, read_frames
from audio_checks.wav.layout import STREAM_SIZE, Chunk, SampleLoop, StructureWarning, WavLayout, stretch_of
from audio_checks.wav.reader import UPLOAD_AGAIN, read_layout
from audio_checks.wav.writer import copy_stretch, copy_wav, write_wav

__all__ = [
    "BLOCK_FRAMES",
    "STREAM_SIZE",
    "UPLOAD_AGAIN",
    "Chunk",
    "Decoder",
    "SampleLoop",
    "StructureWarning",
    "WavLayout",
    "blocks",
    "chunk_payload",
    "copy_stretch",
    "copy_wav",
    "decode",
    "decode_to",
    "fill",
    "frames_at_once",
    "open_regular",
    "raw_blocks",
    "read_frames",
    "read_layout",
    "stretch_of",
    "write_wav",
]
