/** How many decoded sounds are cached, besides those that are kept ready. */
const RECENT = 8

/** Decoded previews by address: those used last, and those that come next. */
export class Previews {
  #decoding = new Map<string, Promise<AudioBuffer>>()
  #decoded = new Map<string, AudioBuffer>()
  /** Light previews, for as long as the exact sound is not here. */
  #light = new Map<string, AudioBuffer>()
  #ready = new Set<string>()
  #selected: string | null = null
  #backwards = new WeakMap<AudioBuffer, AudioBuffer>()
  #forwards = new WeakMap<AudioBuffer, AudioBuffer>()
  readonly #decode: (data: ArrayBuffer) => Promise<AudioBuffer>
  readonly #beginsLight: boolean
  /** An exact sound is decoded. */
  onExact: (url: string) => void = () => undefined
  /** Resolves once sounds may be prefetched. */
  readonly released: Promise<void>
  /** Say that the page shows what it has: over a slow network sounds would delay that. */
  release: () => void = () => undefined

  constructor(decode: (data: ArrayBuffer) => Promise<AudioBuffer>, beginsLight = false) {
    this.#decode = decode
    this.#beginsLight = beginsLight
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

  /** What can be heard soonest: the exact sound where it is here, else a light preview of it. */
  async first(url: string): Promise<AudioBuffer> {
    const known = this.#decoded.get(url) ?? this.#light.get(url)
    if (known || !this.#beginsLight) return known ?? this.get(url)
    const lightUrl = `${url}?light=true`
    const running = this.#decoding.get(lightUrl) ?? this.#loadLight(url, lightUrl)
    this.#decoding.set(lightUrl, running)
    try {
      return await running
    } catch {
      return await this.get(url)
    } finally {
      this.#decoding.delete(lightUrl)
    }
  }

  /** Fetch what is selected once sounds may be prefetched, before those that are kept ready. */
  async select(url: string): Promise<AudioBuffer> {
    this.#selected = url
    await this.released
    return this.first(url)
  }

  /**
   * Fetch these in order, one at a time, and keep them decoded: first what can be heard soonest of all, `later` ones
   * included, then the exact sounds. What fails is tried again when it is played.
   */
  keepReady(urls: readonly string[], later: readonly string[] = []): void {
    this.#ready = new Set([...urls, ...later])
    void this.#getInTurn(urls, this.#beginsLight ? later : [])
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
    this.#light.clear()
    this.#ready.clear()
  }

  async #getInTurn(urls: readonly string[], later: readonly string[]): Promise<void> {
    const ready = this.#ready
    await this.released
    const selected = this.#selected === null ? [] : [this.#selected]
    const soonest = [...selected, ...urls, ...later].map((url) => () => this.first(url))
    const exact = [...selected, ...urls].map((url) => () => this.get(url))
    for (const load of this.#beginsLight ? [...soonest, ...exact] : exact) {
      while (this.#decoding.size > 0) await Promise.allSettled(this.#decoding.values())
      if (ready !== this.#ready) return // a newer list is fetched instead
      await load().catch(() => undefined)
    }
  }

  async #load(url: string): Promise<AudioBuffer> {
    return this.#isExact(url, (await this.#fetched(url)).buffer)
  }

  async #loadLight(url: string, lightUrl: string): Promise<AudioBuffer> {
    const { buffer, isLight } = await this.#fetched(lightUrl)
    // An older sound has no light preview: the server sent the exact one.
    if (!isLight) return this.#isExact(url, buffer)
    this.#light.set(url, buffer)
    this.#forget()
    return buffer
  }

  async #fetched(url: string): Promise<{ buffer: AudioBuffer; isLight: boolean }> {
    const response = await fetch(url, { credentials: 'same-origin' })
    if (!response.ok) throw new Error(`preview answered ${response.status}`)
    const isLight = response.headers.get('content-type')?.startsWith('audio/ogg') === true
    return { buffer: await this.#decode(await response.arrayBuffer()), isLight }
  }

  #isExact(url: string, buffer: AudioBuffer): AudioBuffer {
    this.#decoded.set(url, buffer)
    this.#light.delete(url)
    this.#forget()
    this.onExact(url)
    return buffer
  }

  #forget(): void {
    for (const sounds of [this.#decoded, this.#light]) {
      const idle = [...sounds.keys()].filter((url) => !this.#ready.has(url))
      for (const url of idle.slice(0, Math.max(0, idle.length - RECENT))) sounds.delete(url)
    }
  }
}
