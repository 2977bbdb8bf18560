import type { Clock } from './clock'
import type { TimeRange } from './draw'
import { direct, type MakeOutput, type Output } from './output'
import { type Company, type PlayerState, SILENT, type Source } from './playerState'
import { Previews } from './previews'
import { SetPlayback } from './setPlayback'
import { ONE_AFTER_ANOTHER, type SetWay } from './setSchedule'

interface Sounding {
  node: AudioBufferSourceNode
  gain: GainNode
  buffer: AudioBuffer
  /** Where in the buffer it began, and when by the context's clock. */
  fromS: number
  atS: number
  /** 2 where it is played an octave up. */
  speed: number
}

export interface PlayerParts {
  createContext?: () => AudioContext
  random?: () => number
  /** Calls back before the next frame, and answers how to take that back. */
  onFrame?: (callback: () => void) => () => void
  reducedMotion?: () => boolean
  now?: () => number
  /** Fetch no sound before one is played, or before `previews.release`. */
  held?: boolean
  /** Begin with light previews, where the browser plays them. */
  light?: boolean
}

/** Long enough that a switch does not click, too short to hear as a fade. */
const FADE_S = 0.005
const LEAST_LEAD_S = 0.015
const REDUCED_STEP_MS = 100
/** One way of hearing fades into another: long enough that the filters of the new one have settled. */
const CROSSFADE_S = 0.02
/** What was faded out is taken away so much later; nobody hears when. */
const REMOVE_AFTER_MS = 250

const everyFrame = (callback: () => void): (() => void) => {
  const frame = requestAnimationFrame(callback)
  return () => cancelAnimationFrame(frame)
}

/** Plays one sound at a time from decoded previews, and only when asked to. Switching keeps the position to the sample. */
export class Player implements Clock {
  readonly previews: Previews
  #context: AudioContext | null = null
  #state = SILENT
  #source: Source | null = null
  #sounding: Sounding | null = null
  /** The position in the original sound, also while it plays backwards. */
  #positionS = 0
  #asked = 0
  #stateListeners = new Set<() => void>()
  #clockListeners = new Set<() => void>()
  #endFrame: (() => void) | null = null
  #steppedAt = -Infinity
  #set: { sources: readonly Source[]; playback: SetPlayback } | null = null
  #makeOutput: MakeOutput = direct
  #output: Output | null = null
  /** All that sounds passes here before the output; 1 but where a mix comes down. */
  #mix: GainNode | null = null
  #mixGain = 1
  #company: { sounds: Company; bus: GainNode } | null = null
  #hushed = false
  readonly #createContext: () => AudioContext
  readonly #random: () => number
  readonly #onFrame: (callback: () => void) => () => void
  readonly #reducedMotion: () => boolean
  readonly #now: () => number

  constructor(parts: PlayerParts = {}) {
    this.#createContext = parts.createContext ?? (() => new AudioContext())
    this.#random = parts.random ?? Math.random
    this.#onFrame = parts.onFrame ?? everyFrame
    this.#reducedMotion = parts.reducedMotion ?? (() => matchMedia('(prefers-reduced-motion: reduce)').matches)
    this.#now = parts.now ?? (() => performance.now())
    this.previews = new Previews((data) => this.#contextNow().decodeAudioData(data), parts.light)
    this.previews.onExact = (url) => this.#exactIsHere(url)
    if (!parts.held) this.previews.release()
  }

  // Its listeners

  getState = (): PlayerState => this.#state

  subscribeState = (listener: () => void): (() => void) => {
    this.#stateListeners.add(listener)
    return () => this.#stateListeners.delete(listener)
  }

  subscribe = (listener: () => void): (() => void) => {
    this.#clockListeners.add(listener)
    return () => this.#clockListeners.delete(listener)
  }

  isPlaying = (): boolean => this.#sounding !== null

  positionS = (): number => this.#positionAtS()

  // What it is asked

  /**
   * Select a sound. While another plays, this one takes over at the same position, or so much later as the
   * same moment lies later in it.
   */
  async select(source: Source, laterS = 0): Promise<void> {
    this.#leaveSet()
    const known = this.#source
    if (known?.id === source.id && known.url === source.url && known.place === source.place) {
      this.#source = source
      if (this.#sounding) this.#ramp(this.#sounding.gain, this.#gainOf(source))
      return
    }
    const wasPlaying = this.isPlaying()
    this.#source = source
    this.#notify({ sourceId: source.id, error: null })
    const asked = ++this.#asked
    const buffer = await this.#read(source, asked, wasPlaying ? 'soon' : 'released')
    if (buffer === null) return
    this.#notify({ durationS: buffer.duration })
    // Asked again only now: it may have been paused, or have ended, while the other was on its way.
    if (wasPlaying && this.isPlaying()) this.#takeOver(buffer, source, laterS)
    else this.#moved(Math.min(Math.max(0, this.#positionS + laterS), buffer.duration))
  }

  async play(fromS?: number): Promise<void> {
    const source = this.#source
    if (source === null) return
    this.#leaveSet()
    const asked = ++this.#asked
    // Within the press itself, or the browser keeps it silent.
    const context = this.#contextNow()
    if (context.state === 'suspended') void context.resume()
    if (!this.previews.has(source.url)) this.#notify({ status: 'loading', error: null })
    const buffer = await this.#read(source, asked, 'soon')
    if (buffer === null) return
    this.#notify({ durationS: buffer.duration })
    this.#sound(buffer, source, fromS ?? this.#startS(buffer.duration))
    void this.previews.get(source.url).catch(() => undefined) // the preview goes on
  }

  pause(): void {
    this.#asked += 1
    this.#leaveSet()
    const positionS = this.positionS()
    this.#silence()
    this.#notify({ status: this.#source === null ? 'silent' : 'paused' })
    this.#moved(positionS)
  }

  async toggle(): Promise<void> {
    if (this.isPlaying()) this.pause()
    else await this.play()
  }

  seek(s: number): void {
    this.#leaveSet()
    const positionS = Math.max(0, this.#state.durationS > 0 ? Math.min(s, this.#state.durationS) : s)
    const { buffer } = this.#sounding ?? {}
    if (buffer && this.#source) this.#sound(this.previews.forwardsOf(buffer), this.#source, positionS)
    else this.#moved(positionS)
  }

  setLooping(looping: boolean): void {
    this.#change({ looping })
  }

  setRange(range: TimeRange | null): void {
    this.#change({ range: range && range.endS > range.startS ? range : null })
  }

  setReversed(reversed: boolean): void {
    if (reversed === this.#state.reversed) return
    this.#leaveSet()
    const positionS = this.positionS()
    const { buffer } = this.#sounding ?? {}
    this.#silence()
    this.#notify({ reversed })
    if (buffer && this.#source) this.#sound(this.previews.forwardsOf(buffer), this.#source, positionS)
    else this.#moved(positionS)
  }

  /** Bring every source to the same level, or hear each as it was sent. */
  setMatched(matched: boolean): void {
    this.#notify({ matched })
    const sounding = this.#sounding
    if (sounding && this.#source) this.#ramp(sounding.gain, this.#gainOf(this.#source))
  }

  /** Hear others beside the source, on the same clock; null for the source alone. */
  setCompany(sounds: Company | null): void {
    if (this.#company?.sounds === (sounds ?? undefined)) return
    this.#endCompany()
    this.#company = sounds && { sounds, bus: this.#contextNow().createGain() }
    const sounding = this.#sounding
    if (this.#company === null || sounding === null || this.#set !== null) return
    this.#company.bus.connect(this.#mixNow(this.#contextNow()))
    this.#beginCompany(this.#bufferPositionS(sounding), this.#loopOf(sounding.buffer.duration))
  }

  /** Silence the source while the others go on, for as long as it is so. */
  setHushed(hushed: boolean): void {
    this.#hushed = hushed
    const sounding = this.#sounding
    if (sounding && this.#source) this.#ramp(sounding.gain, this.#gainOf(this.#source))
  }

  /** Bring down all that sounds together: the source and its company. */
  setMixGain(gainDb: number): void {
    this.#mixGain = 10 ** (gainDb / 20)
    if (this.#mix) this.#ramp(this.#mix, this.#mixGain)
  }

  /** The context in which all of it sounds. */
  context = (): BaseAudioContext => this.#contextNow()

  /** Where the listener is: the position, but for what the device is late. */
  heardS = (): number => {
    const lateS = this.isPlaying() ? (this.#context?.outputLatency ?? 0) : 0
    return Math.max(0, this.positionS() - lateS)
  }

  /** Hear everything through other nodes, or directly. What sounds goes on without a gap, at the same position. */
  setOutput(makeOutput: MakeOutput = direct): void {
    if (makeOutput === this.#makeOutput) return
    this.#makeOutput = makeOutput
    const before = this.#output
    if (before === null || this.#context === null) return
    const context = this.#context
    const after = makeOutput(context)
    this.#output = after
    const mix = this.#mixNow(context)
    mix.connect(after.input)
    if (this.#set === null && this.#sounding === null) {
      mix.disconnect(before.input)
      before.remove()
      return
    }
    after.gain.gain.setValueAtTime(0, context.currentTime)
    after.gain.gain.linearRampToValueAtTime(1, context.currentTime + CROSSFADE_S)
    this.#ramp(before.gain, 0, CROSSFADE_S)
    after.onSounding?.('begins')
    setTimeout(() => {
      mix.disconnect(before.input)
      before.remove()
    }, REMOVE_AFTER_MS)
  }

  /** Play variations at random, never the same twice running, as often and as evenly as `way` says, until `pause`. */
  async playAsGame(sources: readonly Source[], way: SetWay = ONE_AFTER_ANOTHER): Promise<void> {
    if (sources.length === 0) return
    const asked = ++this.#asked
    const context = this.#contextNow()
    if (context.state === 'suspended') void context.resume()
    this.#leaveSet()
    this.#silence()
    this.#notify({ status: 'loading', error: null })
    const read = await Promise.all(sources.map((source) => this.#read(source, asked, 'exact')))
    const buffers = read.flatMap((buffer) => buffer ?? [])
    if (asked !== this.#asked || buffers.length < sources.length) return
    const { reversed } = this.#state
    const to = this.#mixNow(context)
    const playback = new SetPlayback({
      context,
      to,
      buffers: reversed ? buffers.map((buffer) => this.previews.reversed(buffer, context)) : buffers,
      way,
      random: this.#random,
      gainOf: (index) => (sources[index] ? this.#gainOf(sources[index]) : 1),
    })
    this.#set = { sources, playback }
    this.#output?.onSounding?.('begins')
    this.#notify({ asGame: true, status: 'playing' })
    this.#followSet()
    this.#tick()
  }

  dispose(): void {
    this.pause()
    void this.#context?.close()
    this.#context = null
    this.#output = null
    this.#mix = null
    this.previews.clear()
  }

  // How it does it

  /** Take into the hand what of the set began last. */
  #followSet(): void {
    const set = this.#set
    const hit = set?.playback.current()
    const source = hit && set?.sources[hit.index]
    if (!hit || !source || this.#sounding?.node === hit.node) return
    this.#source = source
    this.#sounding = { ...hit, fromS: 0, atS: hit.startsAtS }
    this.#notify({ sourceId: source.id, durationS: hit.buffer.duration })
  }

  #contextNow(): AudioContext {
    this.#context ??= this.#createContext()
    return this.#context
  }

  /** What all that sounds is connected to. */
  #mixNow(context: AudioContext): GainNode {
    if (this.#mix === null) {
      this.#output = this.#makeOutput(context)
      this.#mix = context.createGain()
      this.#mix.gain.value = this.#mixGain
      this.#mix.connect(this.#output.input)
    }
    return this.#mix
  }

  /** The sound itself; null where another was asked for meanwhile, or it could not be loaded. */
  async #read(source: Source, asked: number, how: 'soon' | 'released' | 'exact'): Promise<AudioBuffer | null> {
    const read = { soon: 'first', released: 'select', exact: 'get' } as const
    try {
      const buffer = await this.previews[read[how]](source.url)
      if (asked !== this.#asked) return null
      this.#notify({ isLight: !this.previews.has(source.url) })
      return source.place?.(buffer, this.#contextNow()) ?? buffer
    } catch {
      if (asked !== this.#asked) return null
      this.#silence()
      this.#notify({ status: 'paused', error: 'The sound could not be loaded. Press Play to try again.' })
      return null
    }
  }

  /** Put the exact sound in the place of its preview: at the same sample, without a gap. */
  #exactIsHere(url: string): void {
    const source = this.#source
    if (source?.url !== url || !this.#state.isLight) return
    this.#notify({ isLight: false })
    if (this.#sounding === null || this.#set !== null) return
    const asked = this.#asked
    void this.#read(source, asked, 'exact').then((buffer) => {
      if (buffer && this.isPlaying()) this.#takeOver(buffer, source)
    })
  }

  /** The next time at which the device begins a sound to the sample: what should begin sooner begins late. */
  #soonS(context: AudioContext): number {
    const latencyS = context.baseLatency as number | undefined // rendered by itself, a context has none
    return context.currentTime + (latencyS === undefined ? 0 : Math.max(LEAST_LEAD_S, 2 * latencyS))
  }

  /** Sound in the place of what sounds now, at the same moment of it, or so much later. */
  #takeOver(buffer: AudioBuffer, source: Source, laterS = 0): void {
    const atS = this.#soonS(this.#contextNow())
    this.#sound(buffer, source, Math.max(0, this.#positionAtS(atS) + laterS), atS)
  }

  #sound(given: AudioBuffer, source: Source, positionS: number, atS = this.#soonS(this.#contextNow())): void {
    this.previews.release()
    const context = this.#contextNow()
    const { reversed } = this.#state
    const buffer = reversed ? this.previews.reversed(given, context) : given
    const loop = this.#loopOf(buffer.duration)
    let fromS = Math.min(buffer.duration, Math.max(0, reversed ? buffer.duration - positionS : positionS))
    if (loop && (fromS < loop.startS || fromS >= loop.endS)) fromS = loop.startS
    this.#silence({ alone: true, atS })
    if (fromS >= buffer.duration) {
      this.#ended()
      return
    }

    const node = context.createBufferSource()
    const gain = context.createGain()
    node.buffer = buffer
    if (loop) {
      node.loop = true
      node.loopStart = loop.startS
      node.loopEnd = loop.endS
    }
    node.connect(gain)
    const mix = this.#mixNow(context)
    gain.connect(mix)
    this.#output?.onSounding?.('begins')
    // A start at the very beginning keeps its attack; anywhere else a short ramp keeps it from clicking.
    gain.gain.setValueAtTime(fromS === 0 ? this.#gainOf(source) : 0, atS)
    gain.gain.linearRampToValueAtTime(this.#gainOf(source), atS + FADE_S)
    node.start(atS, fromS)
    const sounding: Sounding = { node, gain, buffer, fromS, atS, speed: 1 }
    node.onended = () => {
      if (this.#sounding === sounding) this.#ended()
    }
    this.#sounding = sounding
    this.#company?.bus.connect(mix)
    this.#beginCompany(fromS, loop, atS)
    this.#notify({ status: 'playing' })
    this.#tick()
  }

  #beginCompany(fromS: number, loop: TimeRange | null, atS = this.#contextNow().currentTime): void {
    if (this.#company === null) return
    const context = this.#contextNow()
    this.#company.sounds.begin({ context, to: this.#company.bus, atS, fromS, loop })
  }

  #endCompany(): void {
    this.#company?.sounds.end((this.#context?.currentTime ?? 0) + FADE_S)
  }

  #ended(): void {
    const { durationS, reversed } = this.#state
    this.#sounding = null
    this.#endCompany()
    this.#output?.onSounding?.('is over')
    this.#notify({ status: 'paused' })
    this.#moved(reversed ? 0 : durationS)
  }

  /** Stop what sounds, with a fade that is too short to hear. */
  #silence({ alone = false, atS = this.#context?.currentTime ?? 0 } = {}): void {
    const sounding = this.#sounding
    if (sounding === null) return
    if (!alone) this.#endCompany()
    this.#positionS = this.positionS()
    this.#sounding = null
    sounding.node.onended = null
    this.#ramp(sounding.gain, 0, FADE_S, atS)
    sounding.node.stop(atS + FADE_S)
    this.#output?.onSounding?.('pauses')
    this.#endFrame?.()
    this.#endFrame = null
  }

  #ramp(gain: GainNode, to: number, fadeS = FADE_S, now = this.#contextNow().currentTime): void {
    gain.gain.cancelScheduledValues(now)
    gain.gain.setValueAtTime(gain.gain.value, now)
    gain.gain.linearRampToValueAtTime(to, now + fadeS)
  }

  #gainOf(source: Source): number {
    if (this.#hushed) return 0
    return this.#state.matched ? 10 ** ((source.matchGainDb ?? 0) / 20) : 1
  }

  /** What repeats, in the buffer as it is played. */
  #loopOf(durationS: number): TimeRange | null {
    const { looping, range, reversed } = this.#state
    if (!looping) return null
    const startS = Math.max(0, range?.startS ?? 0)
    const endS = Math.min(durationS, range?.endS ?? durationS)
    if (endS <= startS) return { startS: 0, endS: durationS }
    return reversed ? { startS: durationS - endS, endS: durationS - startS } : { startS, endS }
  }

  /** Where in the sound the player is at a time of the context: now, or soon. */
  #positionAtS(atS?: number): number {
    const sounding = this.#sounding
    if (sounding === null) return this.#positionS
    const at = this.#bufferPositionS(sounding, atS)
    return this.#state.reversed ? sounding.buffer.duration - at : at
  }

  #bufferPositionS({ node, buffer, fromS, atS, speed }: Sounding, now = this.#contextNow().currentTime): number {
    const at = fromS + speed * Math.max(0, now - atS)
    if (!node.loop) return Math.min(at, buffer.duration)
    if (at < node.loopEnd) return at
    return node.loopStart + ((at - node.loopStart) % (node.loopEnd - node.loopStart))
  }

  /** Where playing starts by default: at the current position, or from the start after the end. */
  #startS(durationS: number): number {
    const { reversed } = this.#state
    if (reversed) return this.#positionS <= 0 ? durationS : Math.min(this.#positionS, durationS)
    return this.#positionS >= durationS ? 0 : this.#positionS
  }

  #change(change: Partial<PlayerState>): void {
    const sounding = this.#sounding
    if (sounding === null || this.#source === null || this.#set !== null) {
      this.#notify(change)
      return
    }
    const at = this.#bufferPositionS(sounding)
    const positionS = this.positionS()
    this.#notify(change)
    const loop = this.#loopOf(sounding.buffer.duration)
    if (loop && (at < loop.startS || at >= loop.endS)) {
      this.#sound(this.previews.forwardsOf(sounding.buffer), this.#source, positionS)
      return
    }
    // The sound goes on without a gap; only the reference time is reset.
    sounding.fromS = at
    sounding.atS = this.#contextNow().currentTime
    sounding.node.loop = loop !== null
    if (loop) {
      sounding.node.loopStart = loop.startS
      sounding.node.loopEnd = loop.endS
    }
    this.#beginCompany(at, loop)
  }

  #leaveSet(): void {
    if (this.#set === null) return
    this.#set.playback.stop()
    this.#set = null
    this.#silence()
    this.#notify({ asGame: false })
  }

  #moved(positionS: number): void {
    this.#positionS = positionS
    for (const listener of this.#clockListeners) listener()
  }

  #tick(): void {
    this.#endFrame?.()
    this.#endFrame = this.#onFrame(() => {
      this.#endFrame = null
      if (this.#sounding === null) return
      this.#followSet()
      const now = this.#now()
      if (!this.#reducedMotion() || now - this.#steppedAt >= REDUCED_STEP_MS) {
        this.#steppedAt = now
        for (const listener of this.#clockListeners) listener()
      }
      this.#tick()
    })
  }

  #notify(change: Partial<PlayerState>): void {
    this.#state = { ...this.#state, ...change }
    for (const listener of this.#stateListeners) listener()
  }
}
