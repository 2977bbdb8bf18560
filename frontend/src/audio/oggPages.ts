const CAPTURE = [0x4f, 0x67, 0x67, 0x53] // "OggS"
const HEADER_BYTES = 27

/** How many of these first bytes of an Ogg stream are whole pages (RFC 3533, section 6). */
export function wholePagesBytes(bytes: Uint8Array): number {
  let at = 0
  while (CAPTURE.every((byte, index) => bytes[at + index] === byte)) {
    const segments = bytes[at + HEADER_BYTES - 1] ?? 0
    const tableEnd = at + HEADER_BYTES + segments
    if (tableEnd > bytes.length) break
    const end = bytes.subarray(at + HEADER_BYTES, tableEnd).reduce((sum, size) => sum + size, tableEnd)
    if (end > bytes.length) break
    at = end
  }
  return at
}
