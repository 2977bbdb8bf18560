import { crc32 } from 'node:zlib'

interface Sound {
  rateHz?: number
  bits?: 16 | 24
  channels?: number
  seconds?: number
  /** Largest sample, of full scale. */
  peak?: number
  /** Of the tone; two sounds of different pitch are different files. */
  pitchHz?: number
  /** The sound at a time, in place of the tone. */
  shapeAt?: (s: number) => number
}

/** A struck tone that dies away, or another sound: a WAV with nothing in it but `fmt ` and `data`. */
export function wav(sound: Sound = {}): Buffer {
  const { rateHz = 48_000, bits = 24, channels = 1, seconds = 0.3, peak = 0.5, pitchHz = 880 } = sound
  const tone = (t: number) => Math.exp((-4 * t) / seconds) * Math.sin(2 * Math.PI * pitchHz * t)
  const { shapeAt = tone } = sound
  const frames = Math.round(seconds * rateHz)
  const width = bits / 8
  const shape = Float64Array.from({ length: frames }, (_, frame) => shapeAt(frame / rateHz))
  const loudest = shape.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
  const scale = (peak * (2 ** (bits - 1) - 1)) / loudest
  const data = Buffer.alloc(frames * channels * width)
  shape.forEach((value, frame) => {
    for (let channel = 0; channel < channels; channel++) {
      data.writeIntLE(Math.round(value * scale), (frame * channels + channel) * width, width)
    }
  })
  const head = Buffer.alloc(44)
  head.write('RIFF', 0)
  head.writeUInt32LE(36 + data.length, 4)
  head.write('WAVEfmt ', 8)
  head.writeUInt32LE(16, 16)
  head.writeUInt16LE(1, 20)
  head.writeUInt16LE(channels, 22)
  head.writeUInt32LE(rateHz, 24)
  head.writeUInt32LE(rateHz * channels * width, 28)
  head.writeUInt16LE(channels * width, 32)
  head.writeUInt16LE(bits, 34)
  head.write('data', 36)
  head.writeUInt32LE(data.length, 40)
  return Buffer.concat([head, data])
}

/** What the head of a WAV says. */
export function wavFacts(bytes: Buffer) {
  if (bytes.toString('latin1', 0, 4) !== 'RIFF' || bytes.toString('latin1', 8, 12) !== 'WAVE') throw new Error('no WAV')
  const facts: { channels?: number; rateHz?: number; bits?: number; dataBytes?: number } = {}
  for (let at = 12; at + 8 <= bytes.length;) {
    const name = bytes.toString('latin1', at, at + 4)
    const size = bytes.readUInt32LE(at + 4)
    if (name === 'fmt ') {
      facts.channels = bytes.readUInt16LE(at + 10)
      facts.rateHz = bytes.readUInt32LE(at + 12)
      facts.bits = bytes.readUInt16LE(at + 22)
    }
    if (name === 'data') facts.dataBytes = size
    at += 8 + size + (size % 2)
  }
  return facts
}

/** A ZIP of files that are stored as they are. */
export function zip(files: Record<string, Buffer>): Buffer {
  const bodies: Buffer[] = []
  const directory: Buffer[] = []
  let offset = 0
  for (const [name, body] of Object.entries(files)) {
    const path = Buffer.from(name)
    const shared = Buffer.alloc(26)
    shared.writeUInt16LE(20, 0)
    shared.writeUInt32LE(crc32(body), 10)
    shared.writeUInt32LE(body.length, 14)
    shared.writeUInt32LE(body.length, 18)
    shared.writeUInt16LE(path.length, 22)
    const local = Buffer.concat([Buffer.from('PK\x03\x04'), shared, path, body])
    const tail = Buffer.alloc(14)
    tail.writeUInt32LE(offset, 10)
    bodies.push(local)
    directory.push(Buffer.concat([Buffer.from('PK\x01\x02'), Buffer.from([20, 0]), shared, tail, path]))
    offset += local.length
  }
  const listed = Buffer.concat(directory)
  const end = Buffer.alloc(18)
  end.writeUInt16LE(directory.length, 4)
  end.writeUInt16LE(directory.length, 6)
  end.writeUInt32LE(listed.length, 8)
  end.writeUInt32LE(offset, 12)
  return Buffer.concat([...bodies, listed, Buffer.from('PK\x05\x06'), end])
}

/** What a ZIP of stored files holds, in its order. */
export function unzip(archive: Buffer): Map<string, Buffer> {
  const end = archive.lastIndexOf('PK\x05\x06', undefined, 'latin1')
  const files = new Map<string, Buffer>()
  let at = archive.readUInt32LE(end + 16)
  for (let left = archive.readUInt16LE(end + 10); left > 0; left--) {
    const method = archive.readUInt16LE(at + 10)
    if (method !== 0) throw new Error(`an entry is packed by method ${method}`)
    const size = archive.readUInt32LE(at + 24)
    const nameLength = archive.readUInt16LE(at + 28)
    const local = archive.readUInt32LE(at + 42)
    const start = local + 30 + archive.readUInt16LE(local + 26) + archive.readUInt16LE(local + 28)
    files.set(archive.toString('utf8', at + 46, at + 46 + nameLength), archive.subarray(start, start + size))
    at += 46 + nameLength + archive.readUInt16LE(at + 30) + archive.readUInt16LE(at + 32)
  }
  return files
}
