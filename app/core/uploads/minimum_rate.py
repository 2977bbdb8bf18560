"""The minimum rate of an upload: a sender of a byte a minute would hold a connection for weeks."""

import asyncio
from collections.abc import AsyncIterator
from dataclasses import dataclass

from app.core.uploads.errors import UploadStalled


@dataclass(frozen=True)
class MinimumRate:
    """A minimum mean rate, over windows in which the server waits for the sender."""

    bytes_per_s: int = 1 << 10
    window_s: float = 60.0

    async def hold(self, stream: AsyncIterator[bytes]) -> AsyncIterator[bytes]:
        """Yield the bytes; raise UploadStalled once a window ends with fewer bytes than the rate requires.

        Only the wait for the next bytes counts: the time in which they are written is the server's.
        """
        now = asyncio.get_running_loop().time
        window_bytes = self.bytes_per_s * self.window_s
        chunks = aiter(stream)
        left_s, came_bytes = self.window_s, 0
        while True:
            begun = now()
            try:
                async with asyncio.timeout(left_s):
                    chunk = await anext(chunks)
            except StopAsyncIteration:
                return
            except TimeoutError:
                raise UploadStalled(
                    f"{came_bytes:,} bytes came in {self.window_s:g} s; an upload sends {window_bytes:,.0f} or more",
                    fix="ask for the offset of the upload and continue there, or send it again on a faster connection",
                ) from None
            left_s -= now() - begun
            came_bytes += len(chunk)
            if came_bytes >= window_bytes:
                left_s, came_bytes = self.window_s, 0
            yield chunk
