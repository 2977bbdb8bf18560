"""FLAC files written bit by bit from the format's definition, with every kind of subframe: RFC 9639, 9.

Encoders choose what packs best and never write some valid kinds; a reader meets those in files of others.
"""

import hashlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from tests.support import flacs

Whole = NDArray[np.int64]
Subframe = Callable[[Whole, int], Iterator[tuple[int, int]]]  # of samples and their bits: values and their widths
DEPTH_CODES = {8: 1, 16: 4, 24: 6}
LEFT_SIDE, SIDE_RIGHT, MID_SIDE = 8, 9, 10


def packed(fields: Iterable[tuple[int, int]]) -> bytes:
    """Values of some bits each, one after the other, filled up with zeros to whole bytes."""
    text = "".join(format(value & (1 << width) - 1, f"0{width}b") for value, width in fields if width)
    text += "0" * (-len(text) % 8)
    return int(text, 2).to_bytes(len(text) // 8, "big")


def checksum(content: bytes, bits: int, polynomial: int) -> int:
    """The cyclic redundancy check of some bytes."""
    rest = 0
    for byte in content:
        rest ^= byte << bits - 8
        for _ in range(8):
            rest = (rest << 1) ^ (polynomial if rest >> bits - 1 else 0)
            rest &= (1 << bits) - 1
    return rest


def constant(samples: Whole, bits: int) -> Iterator[tuple[int, int]]:
    """One value for all."""
    yield from ((0, 8), (int(samples[0]), bits))


def verbatim(samples: Whole, bits: int) -> Iterator[tuple[int, int]]:
    """The samples as they are."""
    yield (1 << 1, 8)
    yield from ((int(sample), bits) for sample in samples)


def fixed(samples: Whole, bits: int, *, order: int, **coding: int) -> Iterator[tuple[int, int]]:
    """A fixed predictor, and what it is off by."""
    yield (8 + order << 1, 8)
    yield from ((int(sample), bits) for sample in samples[:order])
    yield from residual(np.diff(samples, n=order), order, len(samples), **coding)


def linear(
    samples: Whole, bits: int, *, coefficients: Sequence[int], shift: int, **coding: int
) -> Iterator[tuple[int, int]]:
    """A linear predictor with coefficients of 15 bits, the nearest sample first, and what it is off by."""
    order = len(coefficients)
    yield (31 + order << 1, 8)
    yield from ((int(sample), bits) for sample in samples[:order])
    yield from ((14, 4), (shift, 5), *((coefficient, 15) for coefficient in coefficients))
    predicted = [
        sum(weight * int(samples[place - 1 - tap]) for tap, weight in enumerate(coefficients)) >> shift
        for place in range(order, len(samples))
    ]
    yield from residual(samples[order:] - np.array(predicted, np.int64), order, len(samples), **coding)


def wasted(samples: Whole, bits: int, *, low: int, kind: Subframe) -> Iterator[tuple[int, int]]:
    """Samples whose lowest bits are all zero and left out."""
    (head, width), *rest = kind(samples >> low, bits - low)
    yield from ((head | 1, width), (1, low), *rest)


def residual(
    off: Whole, order: int, size: int, *, parts: int = 0, five: int = 0, parameter: int = 3, raw: int = 0
) -> Iterator[tuple[int, int]]:
    """Rice codes in 2**parts partitions; with `raw` as numbers of so many bits."""
    width = 5 if five else 4
    yield from ((five, 2), (parts, 4))
    each = size >> parts
    for part in range(1 << parts):
        values = [int(one) for one in off[max(part * each - order, 0) : (part + 1) * each - order]]
        if raw:
            yield from (((1 << width) - 1, width), (raw, 5), *((one, raw) for one in values))
            continue
        yield (parameter, width)
        for value in values:
            folded = 2 * value if value >= 0 else -2 * value - 1
            yield (1, (folded >> parameter) + 1)
            yield (folded, parameter)


def coded_number(value: int) -> bytes:
    """A number as UTF-8 writes a character, up to 36 bits."""
    if value < 0x80:
        return bytes([value])
    more = next(count for count in range(1, 7) if value < 1 << 5 * count + 6)
    tail = [0x80 | value >> 6 * place & 0x3F for place in range(more - 1, -1, -1)]
    return bytes([0xFF << 7 - more & 0xFF | (value >> 6 * more & (1 << max(6 - more, 0)) - 1), *tail])


def frame(samples: Whole, first: int, *, bits: int, assignment: int, kinds: Sequence[Subframe]) -> bytes:
    """One frame of samples of shape (n, channels), with its place in the file."""
    head = packed([(0x7FFC, 15), (1, 1), (7, 4), (0, 4), (assignment, 4), (DEPTH_CODES[bits], 3), (0, 1)])
    head += coded_number(first) + (len(samples) - 1).to_bytes(2, "big")
    head += bytes([checksum(head, 8, 0x07)])
    kept, widths = list(samples.T), [bits] * samples.shape[1]
    if assignment >= LEFT_SIDE:
        left, right = kept
        side = left - right
        kept = {LEFT_SIDE: [left, side], SIDE_RIGHT: [side, right], MID_SIDE: [left + right >> 1, side]}[assignment]
        widths[0 if assignment == SIDE_RIGHT else 1] += 1
    fields = [one for kind, channel, width in zip(kinds, kept, widths, strict=True) for one in kind(channel, width)]
    content = head + packed(fields)
    return content + checksum(content, 16, 0x8005).to_bytes(2, "big")


def flac_of(frames: Sequence[tuple[Whole, int, Sequence[Subframe]]], *, bits: int, rate: int = 48_000) -> bytes:
    """A FLAC file of frames, each with its samples, its assignment of channels and its subframes."""
    sizes = [len(samples) for samples, _, _ in frames]
    channels = frames[0][0].shape[1]
    raw = np.ascontiguousarray(np.concatenate([samples for samples, _, _ in frames]), "<i8").view(np.uint8)
    md5 = hashlib.md5(raw.reshape(-1, 8)[:, : bits // 8].tobytes(), usedforsecurity=False).digest()
    facts = rate << 44 | channels - 1 << 41 | bits - 1 << 36 | sum(sizes)
    info = packed([(min(sizes), 16), (max(sizes), 16), (0, 48)]) + facts.to_bytes(8, "big") + md5
    content = b"fLaC" + flacs.block(0, info, last=True)
    for place, (samples, assignment, kinds) in enumerate(frames):
        content += frame(samples, sum(sizes[:place]), bits=bits, assignment=assignment, kinds=kinds)
    return content


def all_kinds(bits: int) -> bytes:
    """A stereo file that has every kind of subframe, residual and stereo coding in it."""
    rng = np.random.default_rng(bits)
    full = 1 << bits - 1

    def tone(size: int = 64) -> Whole:
        course = np.cumsum(rng.integers(-9, 10, (size, 2)), axis=0)
        return np.asarray(np.clip(course, -full, full - 1), np.int64)

    flat = np.broadcast_to(np.array([-full, full - 1]), (17, 2)).astype(np.int64)
    noise = rng.integers(-full, full, (33, 2)).astype(np.int64)
    kinds: list[tuple[Whole, int, Sequence[Subframe]]] = [(flat, 1, [constant, constant])]
    kinds += [(noise, assignment, [verbatim, verbatim]) for assignment in (1, LEFT_SIDE, SIDE_RIGHT, MID_SIDE)]
    for order in range(5):
        plain = partial(fixed, order=order, parts=order % 3)
        kinds.append((tone(), LEFT_SIDE + order % 3, [plain, partial(fixed, order=order, five=1, parameter=0)]))
    for order in range(1, 33):
        coefficients = [2**12, *(int(integer) for integer in rng.integers(-40, 40, order - 1))]
        some = partial(linear, coefficients=coefficients, shift=12, parts=order % 2, parameter=4)
        kinds.append((tone(96), LEFT_SIDE + order % 3, [some, some]))
    escaped = partial(fixed, order=1, parts=1, raw=bits + 2)
    kinds.append((noise[:32], 1, [escaped, partial(fixed, order=1, raw=bits + 2, five=1)]))
    kinds.append((np.zeros((16, 2), np.int64), MID_SIDE, [partial(fixed, order=0, parameter=0), constant]))
    kinds.append((tone() >> 3 << 3, 1, [partial(wasted, low=3, kind=verbatim)] * 2))
    kinds.append((noise[:1], 1, [verbatim, constant]))
    kinds.append((noise[:30] // 8, 1, [partial(fixed, order=2, parameter=bits - 4, five=1)] * 2))
    return flac_of(kinds, bits=bits)
