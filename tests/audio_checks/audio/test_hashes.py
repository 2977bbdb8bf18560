"""Both hashes, with the processor's own instructions and without, held to hashlib."""

import hashlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel
from audio_checks.audio import hashes
from audio_checks.audio.hashes import Hashes

PIECES = st.lists(st.tuples(st.booleans(), st.binary(max_size=400)), max_size=12)


def held_to_hashlib(pieces: list[tuple[bool, bytes]]) -> None:
    both = Hashes()
    for is_sound, piece in pieces:
        (both.add_sound if is_sound else both.add_around)(piece)
    whole = hashlib.sha256(b"".join(piece for _, piece in pieces))
    sound = hashlib.sha256(b"".join(piece for is_sound, piece in pieces if is_sound))
    assert both.result() == (whole.hexdigest(), sound.hexdigest())


@pytest.mark.slow
@given(PIECES)
def test_pieces_of_any_length_in_any_order(pieces: list[tuple[bool, bytes]]):
    held_to_hashlib(pieces)


def test_a_processor_without_instructions_for_it(monkeypatch):
    monkeypatch.setattr(hashes.kernel, "hashes_two", lambda: False)
    held_to_hashlib([(False, b"RIFF" * 11), (True, bytes(range(256)) * 9), (False, b"LIST")])


@pytest.mark.parametrize("size", [*range(130), 1_000_003])
def test_messages_around_the_length_of_a_block(size: int):
    if not kernel.hashes_two():
        pytest.skip("this processor has no instructions for SHA-256")
    message = bytes(index * 7 & 0xFF for index in range(size))
    stream = kernel.hash_begin()
    kernel.hash_add(stream, message)
    assert kernel.hash_end(stream) == hashlib.sha256(message).digest()
    kernel.hash_add(stream, b"more")
    assert kernel.hash_end(stream) == hashlib.sha256(message + b"more").digest()


def test_data_that_is_not_a_stream_is_refused():
    with pytest.raises(ValueError, match="wanted"):
        kernel.hash_add(bytearray(7), b"sound")
    with pytest.raises(TypeError):
        kernel.hash_end()
