import { wholePagesBytes } from './oggPages'

/** So many bytes hold the headers of Vorbis and half a second; they come with the first packets of a connection. */
export const FIRST_BYTES = 12_000
/** What a decoder makes of the last blocks of a stream that was cut is not the sound. */
const LAST_BLOCKS_S = 0.1

type Decode = (data: ArrayBuffer) => Promise<AudioBuffer>

/** The first seconds of a sound, decoded. */
export interface Beginning {
  buffer: AudioBuffer
  untilS: number
  /** Of how many bytes it was made. */
  bytes: number
}

export const isLight = ({ headers }: Response): boolean => headers.get('content-type')?.startsWith('audio/ogg') === true

/** A preview on its way: the whole of it, and what is here already of an Ogg stream. */
export class PreviewLoad {
  readonly whole: Promise<{ buffer: AudioBuffer; isLight: boolean }>
  readonly #decode: Decode
  #isLight = false
  #isOver = false
  #chunks: Uint8Array[] = []
  #bytes = 0
  #waiting: (() => void)[] = []
  /** The first bytes, where they were fetched before. */
  readonly #head: Uint8Array<ArrayBuffer> | null

  constructor(url: string, decode: Decode, head: Uint8Array<ArrayBuffer> | null = null) {
    this.#decode = decode
    this.#head = head
    this.whole = this.#load(url).finally(() => {
      this.#isOver = true
      this.#wake()
    })
    this.whole.catch(() => undefined) // who waits for it has the error
  }

  /** The beginning, once it is twice as long as so many bytes; null where the whole is here sooner. */
  async longer(thanBytes = 0): Promise<Beginning | null> {
    const leastBytes = Math.max(FIRST_BYTES, 2 * thanBytes)
    const head = this.#head && this.#bytes < leastBytes && thanBytes < this.#head.length ? this.#head : null
    while (!head && !this.#isOver && (!this.#isLight || this.#bytes < leastBytes)) {
      await new Promise<void>((resolve) => this.#waiting.push(resolve))
    }
    if (this.#isOver) return null
    const bytes = head ?? joined(this.#chunks, this.#bytes)
    // What cannot be decoded was too little: the next one is longer.
    const buffer = await this.#decode(bytes.buffer.slice(0, wholePagesBytes(bytes))).catch(() => null)
    if (this.#isOver) return null
    const untilS = (buffer?.duration ?? 0) - LAST_BLOCKS_S
    return buffer && untilS > 0 ? { buffer, untilS, bytes: bytes.length } : this.longer(bytes.length)
  }

  async #load(url: string): Promise<{ buffer: AudioBuffer; isLight: boolean }> {
    const response = await fetch(url, { credentials: 'same-origin' })
    if (!response.ok) throw new Error(`preview answered ${response.status}`)
    this.#isLight = isLight(response)
    const reader = response.body?.getReader()
    for (let read = await reader?.read(); read?.value; read = await reader?.read()) {
      this.#chunks.push(read.value)
      this.#bytes += read.value.length
      this.#wake()
    }
    return { buffer: await this.#decode(joined(this.#chunks, this.#bytes).buffer), isLight: this.#isLight }
  }

  #wake(): void {
    for (const resolve of this.#waiting.splice(0)) resolve()
  }
}

function joined(chunks: readonly Uint8Array[], length: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(length)
  let at = 0
  for (const chunk of chunks) {
    bytes.set(chunk, at)
    at += chunk.length
  }
  return bytes
}
