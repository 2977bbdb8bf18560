import { type Beginning, FIRST_BYTES, isLight, PreviewLoad } from './previewLoad'

/** How many decoded sounds are cached, besides those that are kept ready. */
const RECENT = 8
/** Less than this is not begun with. */
const LEAST_S = 0.1

/** From where on a sound is wanted, and how long all of it is. */
export interface Wanted {
  fromS: number
  durationS: number
}

interface Begun {
  begun: Beginning
  durationS: number
  whole: Promise<AudioBuffer>
}

/** Decoded previews by address: those used last, and those that come next. */
export class Previews {
  #decoding = new Map<string, Promise<AudioBuffer>>()
  #loads = new Map<string, PreviewLoad>()
  #decoded = new Map<string, AudioBuffer>()
  /** Light previews, for as long as the exact sound is not here. */
  #light = new Map<string, AudioBuffer>()
  /** The first bytes of light previews of which no more is here. */
  #heads = new Map<string, Uint8Array<ArrayBuffer>>()
  /** Until where there is sound in the buffer of a beginning; the rest is silent. */
  #untilS = new WeakMap<AudioBuffer, number>()
  /** How many beginnings were given. */
  #begun = 0
  #ready = new Set<string>()
  #selected: string | null = null
  #backwards = new WeakMap<AudioBuffer, AudioBuffer>()
  #forwards = new WeakMap<AudioBuffer, AudioBuffer>()
  readonly #decode: (data: ArrayBuffer) => Promise<AudioBuffer>
  readonly #beginsLight: boolean
  readonly #createBuffer: BaseAudioContext['createBuffer']
  /** The exact sound is here, or more of it than the beginning that was given. */
  onBetter: (url: string, buffer: AudioBuffer) => void = () => undefined
  /** Resolves once sounds may be prefetched. */
  readonly released: Promise<void>
  /** Say that the page shows what it has: over a slow network sounds would delay that. */
  release: () => void = () => undefined

  constructor(contextNow: () => BaseAudioContext, beginsLight = false) {
    this.#decode = (data) => contextNow().decodeAudioData(data)
    this.#createBuffer = (...given) => contextNow().createBuffer(...given)
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

  /** What can be heard soonest of all of it: the exact sound where it is here, else a light preview. */
  async first(url: string): Promise<AudioBuffer> {
    const known = this.#decoded.get(url) ?? this.#light.get(url)
    if (known || !this.#beginsLight) return known ?? this.get(url)
    const lightUrl = lightUrlOf(url)
    const running = this.#decoding.get(lightUrl) ?? this.#loadLight(url)
    this.#decoding.set(lightUrl, running)
    try {
      return await running
    } catch {
      return await this.get(url)
    } finally {
      this.#decoding.delete(lightUrl)
    }
  }

  /**
   * What can be heard soonest from a place on: as `first`, or before that is here a beginning of the light preview, in
   * a buffer as long as the sound. `onBetter` is then called with longer ones, and last with what `first` gives.
   */
  async beginning(url: string, { fromS, durationS }: Wanted): Promise<AudioBuffer> {
    const whole = this.first(url)
    const load = this.#loads.get(url)
    if (load === undefined) return whole
    whole.catch(() => undefined) // who waits for it has the error
    for (let begun = await load.longer(); begun; begun = await load.longer(begun.bytes)) {
      if (begun.untilS < fromS + LEAST_S) continue
      void this.#goOn(url, load, { begun, durationS, whole })
      return this.#lengthened(begun, durationS)
    }
    return whole
  }

  /** Fetch the exact sound too, once all of it can be heard. */
  async complete(url: string): Promise<void> {
    await this.first(url)
    await this.get(url)
  }

  /** Until where there is sound in a buffer. */
  untilS(buffer: AudioBuffer): number {
    return this.#untilS.get(buffer) ?? buffer.duration
  }

  isBeginning(buffer: AudioBuffer): boolean {
    return this.#untilS.has(buffer)
  }

  /** Fetch what is selected once sounds may be prefetched, before those that are kept ready. */
  async select(url: string): Promise<AudioBuffer> {
    this.#selected = url
    await this.released
    return this.first(url)
  }

  /**
   * Fetch these in order, one at a time, and keep them decoded: first what can be heard soonest of all, `later` ones
   * included, then the first bytes of `others`, then the exact sounds. What fails is tried again when it is played.
   */
  keepReady(urls: readonly string[], later: readonly string[] = [], others: readonly string[] = []): void {
    this.#ready = new Set([...urls, ...later])
    for (const url of this.#heads.keys()) if (!others.includes(url) && !this.#ready.has(url)) this.#heads.delete(url)
    void this.#getInTurn(urls, this.#beginsLight ? later : [], this.#beginsLight ? others : [])
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
    this.#heads.clear()
    this.#ready.clear()
  }

  async #getInTurn(urls: readonly string[], later: readonly string[], others: readonly string[]): Promise<void> {
    const ready = this.#ready
    await this.released
    const selected = this.#selected === null ? [] : [this.#selected]
    const soonest = [...selected, ...urls, ...later].map((url) => () => this.first(url))
    const heads = others.map((url) => () => this.#fetchHead(url))
    const exact = [...selected, ...urls].map((url) => () => this.get(url))
    for (const load of this.#beginsLight ? [...soonest, ...heads, ...exact] : exact) {
      while (this.#decoding.size > 0) await Promise.allSettled(this.#decoding.values())
      if (ready !== this.#ready) return // a newer list is fetched instead
      await load().catch(() => undefined)
    }
  }

  async #load(url: string): Promise<AudioBuffer> {
    return this.#isExact(url, (await new PreviewLoad(url, this.#decode).whole).buffer)
  }

  async #loadLight(url: string): Promise<AudioBuffer> {
    const load = new PreviewLoad(lightUrlOf(url), this.#decode, this.#heads.get(url))
    this.#heads.delete(url)
    this.#loads.set(url, load)
    try {
      const { buffer, isLight } = await load.whole
      // An older sound has no light preview: the server sent the exact one.
      if (!isLight) return this.#isExact(url, buffer)
      this.#light.set(url, buffer)
      this.#forget()
      return buffer
    } finally {
      this.#loads.delete(url)
    }
  }

  async #fetchHead(url: string): Promise<void> {
    if ([this.#decoded, this.#light, this.#heads, this.#loads].some((here) => here.has(url))) return
    const headers = { Range: `bytes=0-${FIRST_BYTES - 1}` }
    const response = await fetch(lightUrlOf(url), { credentials: 'same-origin', headers })
    if (response.status === 206 && isLight(response)) {
      this.#heads.set(url, new Uint8Array(await response.arrayBuffer()))
    } else await response.body?.cancel()
  }

  /** Hand on what follows a beginning, until another one is asked for. */
  async #goOn(url: string, load: PreviewLoad, { begun, durationS, whole }: Begun): Promise<void> {
    const run = ++this.#begun
    for (let next = await load.longer(begun.bytes); next; next = await load.longer(next.bytes)) {
      if (run !== this.#begun) return
      this.onBetter(url, this.#lengthened(next, durationS))
    }
    const last = await whole.catch(() => null)
    if (last && run === this.#begun) this.onBetter(url, last)
  }

  #lengthened({ buffer, untilS }: Beginning, durationS: number): AudioBuffer {
    const { numberOfChannels, sampleRate } = buffer
    const length = Math.max(buffer.length, Math.round(durationS * sampleRate))
    const lengthened = this.#createBuffer(numberOfChannels, length, sampleRate)
    for (let channel = 0; channel < numberOfChannels; channel += 1) {
      lengthened.copyToChannel(buffer.getChannelData(channel), channel)
    }
    this.#untilS.set(lengthened, untilS)
    return lengthened
  }

  #isExact(url: string, buffer: AudioBuffer): AudioBuffer {
    this.#decoded.set(url, buffer)
    this.#light.delete(url)
    this.#forget()
    this.onBetter(url, buffer)
    return buffer
  }

  #forget(): void {
    for (const sounds of [this.#decoded, this.#light]) {
      const idle = [...sounds.keys()].filter((url) => !this.#ready.has(url))
      for (const url of idle.slice(0, Math.max(0, idle.length - RECENT))) sounds.delete(url)
    }
  }
}

const lightUrlOf = (url: string): string => `${url}?light=true`
