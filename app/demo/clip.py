"""A clip of the demo project, drawn here: Pillow writes VP8 key frames as WebP, and a WebM holds them in order."""

import io
import struct

from PIL import Image, ImageDraw

SIZE = (640, 360)
FRAMES_PER_S = 12
DURATION_S = 4
STARS = [((x * 7_919) % SIZE[0], (x * 104_729) % SIZE[1]) for x in range(1, 70)]
VP8_AT = 20  # bytes of RIFF, WEBP and the head of the only chunk of a lossy WebP file


def warp_in_clip() -> bytes:
    """Return a WebM of a ship that arrives: stars are drawn to a point, a flash, and the ship stands there."""
    frames = [_key_frame(_drawn(number / FRAMES_PER_S)) for number in range(DURATION_S * FRAMES_PER_S)]
    return _webm(frames)


def _drawn(time_s: float) -> Image.Image:
    picture = Image.new("RGB", SIZE, "#0b1016")
    draw = ImageDraw.Draw(picture)
    middle_x, middle_y = SIZE[0] / 2, SIZE[1] / 2
    pulled = min(1.0, time_s / 2)
    for x, y in STARS:
        to_x, to_y = x + (middle_x - x) * 0.5 * pulled, y + (middle_y - y) * 0.5 * pulled
        draw.line([(x + (to_x - x) * 0.8, y + (to_y - y) * 0.8), (to_x, to_y)], fill="#9fb4c4", width=2)
    since_arrival_s = time_s - 2
    if since_arrival_s >= 0:
        reach = 40 + 420 * since_arrival_s
        if since_arrival_s < 0.5:
            box = [middle_x - reach, middle_y - reach / 2, middle_x + reach, middle_y + reach / 2]
            draw.ellipse(box, fill="#dff3f5")
        draw.polygon([(200, 190), (300, 150), (470, 165), (500, 190), (470, 210), (300, 225)], fill="#586b78")
        draw.rectangle([330, 168, 420, 176], fill="#ffd28a")
    return picture


def _key_frame(picture: Image.Image) -> bytes:
    out = io.BytesIO()
    picture.save(out, "WEBP", quality=60, method=0)
    size = int.from_bytes(out.getvalue()[VP8_AT - 4 : VP8_AT], "little")
    return out.getvalue()[VP8_AT : VP8_AT + size]


def _element(name: str, *content: bytes) -> bytes:
    body = b"".join(content)
    return bytes.fromhex(name) + struct.pack(">Q", (1 << 56) | len(body)) + body


def _number(name: str, value: int) -> bytes:
    return _element(name, struct.pack(">I", value))


def _webm(frames: list[bytes]) -> bytes:
    """Return a WebM of key frames: a cluster for each second, and an index of them at the end."""
    head = _element("1a45dfa3", _element("4282", b"webm"), _number("4287", 2), _number("4285", 2))
    info = _element(
        "1549a966",
        _number("2ad7b1", 1_000_000),  # times are in ms
        _element("4489", struct.pack(">d", DURATION_S * 1_000.0)),
        _element("4d80", b"soundlist"),
        _element("5741", b"soundlist"),
    )
    video = _element("e0", _number("b0", SIZE[0]), _number("ba", SIZE[1]))
    track = _element("ae", _number("d7", 1), _number("73c5", 1), _number("83", 1), _element("86", b"V_VP8"), video)
    parts = [info, _element("1654ae6b", track)]
    points = []
    for second in range(DURATION_S):
        start_ms = second * 1_000
        blocks = [
            _element("a3", struct.pack(">BhB", 0x81, 1_000 * index // FRAMES_PER_S, 0x80), frame)
            for index, frame in enumerate(frames[second * FRAMES_PER_S : (second + 1) * FRAMES_PER_S])
        ]
        at = _element("b7", _number("f7", 1), _number("f1", sum(map(len, parts))))
        points.append(_element("bb", _number("b3", start_ms), at))
        parts.append(_element("1f43b675", _number("e7", start_ms), *blocks))
    return head + _element("18538067", *parts, _element("1c53bb6b", *points))
