import type { Page } from '@playwright/test'

export const FRAMES_PER_S = 25
export const WIDTH_BLOCKS = 10

interface Chunk {
  base64: string
  isKey: boolean
}

/** Frames drawn in the browser: ten blocks, black or white, that are the number of the frame. */
const drawn = (page: Page, frames: number): Promise<Chunk[]> =>
  page.evaluate(
    async ([frames, perS, blocks]) => {
      const canvas = new OffscreenCanvas(16 * blocks, 96)
      const context = canvas.getContext('2d')
      const chunks: Chunk[] = []
      const encoder = new VideoEncoder({
        output: (chunk) => {
          const bytes = new Uint8Array(chunk.byteLength)
          chunk.copyTo(bytes)
          const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))
          chunks.push({ base64, isKey: chunk.type === 'key' })
        },
        error: (error) => {
          throw error
        },
      })
      encoder.configure({ codec: 'vp8', width: canvas.width, height: canvas.height, bitrate: 500_000 })
      for (let number = 0; number < frames; number += 1) {
        for (let bit = 0; bit < blocks; bit += 1) {
          if (context) context.fillStyle = (number >> bit) & 1 ? 'white' : 'black'
          context?.fillRect(16 * bit, 0, 16, canvas.height)
        }
        const frame = new VideoFrame(canvas, { timestamp: (1e6 * number) / perS })
        encoder.encode(frame, { keyFrame: number % perS === 0 })
        frame.close()
      }
      await encoder.flush()
      return chunks
    },
    [frames, FRAMES_PER_S, WIDTH_BLOCKS] as const,
  )

/** An element of Matroska. */
function element(id: number, ...content: Buffer[]): Buffer {
  const body = Buffer.concat(content)
  const head = Buffer.alloc(4 + 8)
  const idBytes = Buffer.from(id.toString(16).padStart(2, '0'), 'hex')
  idBytes.copy(head)
  head.writeBigUInt64BE((1n << 56n) | BigInt(body.length), idBytes.length)
  return Buffer.concat([head.subarray(0, idBytes.length + 8), body])
}

const whole = (id: number, value: number): Buffer => {
  const bytes = Buffer.alloc(4)
  bytes.writeUInt32BE(value)
  return element(id, bytes)
}

const text = (id: number, value: string): Buffer => element(id, Buffer.from(value))

const double = (id: number, value: number): Buffer => {
  const bytes = Buffer.alloc(8)
  bytes.writeDoubleBE(value)
  return element(id, bytes)
}

/** A clip whose every frame shows its number, at exact times: a WebM that can be sought in. */
export async function numberedClip(page: Page, seconds: number): Promise<Buffer> {
  const chunks = await drawn(page, seconds * FRAMES_PER_S)
  const info = element(
    0x1549a966,
    whole(0x2ad7b1, 1_000_000), // times are in ms
    double(0x4489, seconds * 1_000),
    text(0x4d80, 'soundlist'),
    text(0x5741, 'soundlist'),
  )
  const size = element(0xe0, whole(0xb0, 16 * WIDTH_BLOCKS), whole(0xba, 96))
  const track = element(0xae, whole(0xd7, 1), whole(0x73c5, 1), whole(0x83, 1), text(0x86, 'V_VP8'), size)
  const head = Buffer.concat([info, element(0x1654ae6b, track)])
  const clusters: Buffer[] = []
  const points: Buffer[] = []
  for (let second = 0, at = head.length; second < seconds; second += 1) {
    const blocks = chunks.slice(second * FRAMES_PER_S, (second + 1) * FRAMES_PER_S).map(({ base64, isKey }, index) => {
      const lead = Buffer.alloc(4)
      lead.writeUInt8(0x81)
      lead.writeInt16BE((1_000 * index) / FRAMES_PER_S, 1)
      lead.writeUInt8(isKey ? 0x80 : 0, 3)
      return element(0xa3, lead, Buffer.from(base64, 'base64'))
    })
    const cluster = element(0x1f43b675, whole(0xe7, second * 1_000), ...blocks)
    points.push(element(0xbb, whole(0xb3, second * 1_000), element(0xb7, whole(0xf7, 1), whole(0xf1, at))))
    clusters.push(cluster)
    at += cluster.length
  }
  return Buffer.concat([
    element(0x1a45dfa3, text(0x4282, 'webm'), whole(0x4287, 2), whole(0x4285, 2)),
    element(0x18538067, head, ...clusters, element(0x1c53bb6b, ...points)),
  ])
}
