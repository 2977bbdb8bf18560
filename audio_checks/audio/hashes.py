"""The two hashes of a file, made while its bytes pass by: of all of them, and of those that are sound."""

import hashlib

from audio_checks import kernel


class Hashes:
    """SHA-256 of a file and of the sound in it.

    Where the processor can, both take the sound's bytes together, in half the time.
    """

    def __init__(self) -> None:
        self._together = (kernel.hash_begin(), kernel.hash_begin()) if kernel.hashes_two() else None
        if not self._together:
            self._whole, self._sound = hashlib.sha256(), hashlib.sha256()

    def add_around(self, piece: bytes | memoryview) -> None:
        """Take bytes before or after the sound."""
        if self._together:
            kernel.hash_add(self._together[0], piece)
        else:
            self._whole.update(piece)

    def add_sound(self, piece: bytes | memoryview) -> None:
        """Take bytes of the sound."""
        if self._together:
            kernel.hash_add(*self._together, piece)
        else:
            self._whole.update(piece)
            self._sound.update(piece)

    def result(self) -> tuple[str, str]:
        """Return both in hexadecimal: of the whole file, and of the sound."""
        if self._together:
            whole, sound = (kernel.hash_end(stream).hex() for stream in self._together)
            return whole, sound
        return self._whole.hexdigest(), self._sound.hexdigest()
