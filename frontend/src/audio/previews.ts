/** How many decoded sounds are cached, besides those that are kept ready. */
const RECENT = 8

/** Decoded previews by address: those used last, and those that come next. */
export class Previews {
  #decoding = new Map<string, Promise<AudioBuffer>>()
  #decoded = new Map<string, AudioBuffer>()
  #ready = new Set<string>()
  #selected: string | null = null
  #backwards = new WeakMap<AudioBuffer, AudioBuffer>()
  #forwards = new WeakMap<AudioBuffer, AudioBuffer>()
  readonly #decode: (data: ArrayBuffer) => Promise<AudioBuffer>
  /** Resolves once sounds may be prefetched. */
  readonly released: Promise<void>
  /** Say that the page shows what it has: over a slow network sounds would delay that. */
  release: () => void = () => undefined

  constructor(decode: (data: ArrayBuffer) => Promise<AudioBuffer>) {
    this.#decode = decode
    this.released = new Promise((resolve) => {
      this.release = resolve
    })
  }

  has(url: string): boolean {
    return this.#decoded.has(url)
  }

  /** Fetch and decode once, however many ask. A failure is forgotten, so that asking again tries again. */
  async get(url: string): Promise<AudioBuffer> {
    const known = this.#decoded.get(url)
    if (known) {
      this.#decoded.delete(url)
      this.#decoded.set(url, known)
      return known
    }
    const running = this.#decoding.get(url) ?? this.#load(url)
    this.#decoding.set(url, running)
    try {
      return await running
    } finally {
      this.#decoding.delete(url)
    }
  }

  /** Fetch what is selected once sounds may be prefetched, before those that are kept ready. */
  async select(url: string): Promise<AudioBuffer> {
    this.#selected = url
    await this.released
    return this.get(url)
  }

  /** Fetch these in order, one at a time, and keep them decoded. What fails is tried again when it is played. */
  keepReady(urls: readonly string[]): void {
    this.#ready = new Set(urls)
    void this.#getInTurn(urls)
  }

  reversed(buffer: AudioBuffer, context: BaseAudioContext): AudioBuffer {
    const known = this.#backwards.get(buffer)
    if (known) return known
    const turned = context.createBuffer(buffer.numberOfChannels, buffer.length, buffer.sampleRate)
    for (let channel = 0; channel < buffer.numberOfChannels; channel += 1) {
      turned.copyToChannel(buffer.getChannelData(channel).slice().reverse(), channel)
    }
    this.#backwards.set(buffer, turned)
    this.#forwards.set(turned, buffer)
    return turned
  }

  /** The sound as it was, of one that may have been turned. */
  forwardsOf(buffer: AudioBuffer): AudioBuffer {
    return this.#forwards.get(buffer) ?? buffer
  }

  clear(): void {
    this.#decoded.clear()
    this.#ready.clear()
  }

  async #getInTurn(urls: readonly string[]): Promise<void> {
    const ready = this.#ready
    await this.released
    const selected = this.#selected === null ? [] : [this.#selected]
    for (const url of [...selected, ...urls]) {
      while (this.#decoding.size > 0) await Promise.allSettled(this.#decoding.values())
      if (ready !== this.#ready) return // a newer list is fetched instead
      await this.get(url).catch(() => undefined)
    }
  }

  async #load(url: string): Promise<AudioBuffer> {
    const response = await fetch(url, { credentials: 'same-origin' })
    if (!response.ok) throw new Error(`preview answered ${response.status}`)
    const buffer = await this.#decode(await response.arrayBuffer())
    this.#decoded.set(url, buffer)
    this.#forget()
    return buffer
  }

  #forget(): void {
    const idle = [...this.#decoded.keys()].filter((url) => !this.#ready.has(url))
    for (const url of idle.slice(0, Math.max(0, idle.length - RECENT))) this.#decoded.delete(url)
  }
}
