import { BackingTracks } from './backingTracks'
import type { Clock } from './clock'
import type { TimeRange } from './draw'
import { Mix } from './mix'
import { direct, type MakeOutput } from './output'
import { loopOf, startOf, wantedOf } from './playbackRange'
import { PlayheadSteps } from './playheadSteps'
import { type Company, type PlayerParts, type PlayerState, type Source, StateStore } from './playerState'
import { Previews, type Wanted } from './previews'
import { heardTimeS, soonS } from './schedule'
import { SetPlayback } from './setPlayback'
import { IN_ORDER, type SetPlaybackMode } from './setSchedule'
import { FADE_S, Voice } from './voice'

/** Plays one sound at a time from decoded previews, and only when asked to. Switching keeps the position to the sample. */
export class Player implements Clock {
  readonly previews: Previews
  #context: AudioContext | null = null
  readonly #store = new StateStore()
  #source: Source | null = null
  #voice: Voice | null = null
  /** The position in the original sound, also while it plays backwards. */
  #positionS = 0
  #asked = 0
  #set: { sources: readonly Source[]; playback: SetPlayback } | null = null
  readonly #mix = new Mix()
  readonly #backingTracks = new BackingTracks()
  #hushed = false
  readonly #createContext: () => AudioContext
  readonly #random: () => number
  readonly #playhead: PlayheadSteps

  constructor(parts: PlayerParts = {}) {
    this.#createContext = parts.createContext ?? (() => new AudioContext())
    this.#random = parts.random ?? Math.random
    this.#playhead = new PlayheadSteps(parts)
    this.previews = new Previews(this.context, parts.light)
    this.previews.onBetter = this.#onHigherQualityReady
    if (!parts.held) this.previews.release()
  }

  getState = (): PlayerState => this.#store.state

  subscribeState = (listener: () => void): (() => void) => this.#store.subscribe(listener)

  subscribe = (listener: () => void): (() => void) => this.#playhead.subscribe(listener)

  isPlaying = (): boolean => this.#voice !== null

  positionS = (): number => this.#placeOf((voice) => voice.positionS())

  /**
   * Select a sound. While another plays, this one takes over at the same position, or so much later as the
   * same moment lies later in it.
   */
  async select(source: Source, laterS = 0): Promise<void> {
    this.#stopSet()
    const known = this.#source
    if (known?.id === source.id && known.url === source.url && known.place === source.place) {
      this.#source = source
      this.#voice?.setGain(this.#gainOf(source))
      return
    }
    const wasPlaying = this.isPlaying()
    this.#source = source
    this.#notify({
      sourceId: source.id,
      takeId: source.takeId ?? null,
      fromStart: !wasPlaying && this.#positionS === 0,
      error: null,
    })
    const asked = ++this.#asked
    const buffer = await this.#read(source, asked, wasPlaying ? 'first' : 'select')
    if (buffer === null) return
    this.#notify({ durationS: buffer.duration })
    // Asked again only now: it may have been paused, or have ended, while the other was on its way.
    if (wasPlaying && this.isPlaying()) this.#takeOver(buffer, source, laterS)
    else this.#moved(Math.min(Math.max(0, this.#positionS + laterS), buffer.duration))
  }

  async play(fromS?: number): Promise<void> {
    const source = this.#source
    if (source === null) return
    this.#stopSet()
    const asked = ++this.#asked
    // Within the press itself, or the browser keeps it silent.
    const context = this.#contextNow()
    if (context.state === 'suspended') void context.resume()
    const isAsked = fromS !== undefined || this.#positionS === 0 // else it goes on from where it was paused
    if (isAsked) this.#notify({ fromStart: !fromS })
    if (!this.previews.has(source.url)) this.#notify({ status: 'loading', error: null })
    const excerpt = wantedOf(source, this.#store.state, fromS ?? this.#positionS)
    const buffer = await this.#read(source, asked, 'first', excerpt)
    if (buffer === null) return
    this.#notify({ durationS: buffer.duration })
    this.#sound(buffer, source, fromS ?? startOf(this.#store.state, this.#positionS, buffer.duration))
    void this.previews.complete(source.url).catch(() => undefined) // the preview goes on
  }

  pause(): void {
    this.#asked += 1
    this.#stopSet()
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
    this.#stopSet()
    const positionS = Math.max(0, this.#store.state.durationS > 0 ? Math.min(s, this.#store.state.durationS) : s)
    this.#notify({ fromStart: positionS === 0 })
    this.#soundOrMove(this.#voice?.buffer, positionS)
  }

  /** How much later than now a sound that starts now is heard. */
  leadS = (): number => soonS(this.#contextNow()) - heardTimeS(this.#contextNow())

  /** Go to a position that moves on by itself: what plays is there when it is heard, not a lead later. */
  align(s: number): void {
    this.seek(s + (this.isPlaying() ? this.leadS() : 0))
  }

  setLooping(looping: boolean): void {
    this.#change({ looping })
  }

  setRange(range: TimeRange | null): void {
    this.#change({ range: range && range.endS > range.startS ? range : null })
  }

  setReversed(reversed: boolean): void {
    if (reversed === this.#store.state.reversed) return
    this.#stopSet()
    const positionS = this.positionS()
    const { buffer } = this.#voice ?? {}
    this.#silence()
    this.#notify({ reversed })
    this.#soundOrMove(buffer, positionS)
  }

  /** Bring every source to the same level, or hear each as it was sent. */
  setMatched(matched: boolean): void {
    this.#notify({ matched })
    if (this.#source) this.#voice?.setGain(this.#gainOf(this.#source))
  }

  /** Hear others beside the source, on the same clock; null for the source alone. */
  setBackingTracks(sounds: Company | null): void {
    if (this.#backingTracks.has(sounds)) return
    this.#endCompany()
    this.#backingTracks.set(sounds, () => this.#contextNow().createGain())
    if (this.#voice !== null && this.#set === null) this.#beginCompany(this.#voice)
  }

  /** Silence the source while the others go on, for as long as it is so. */
  setSoloMuted(hushed: boolean): void {
    this.#hushed = hushed
    if (this.#source) this.#voice?.setGain(this.#gainOf(this.#source))
  }

  /** Bring down all that sounds together: the source and its company. */
  setMixGain(gainDb: number): void {
    this.#mix.setGain(this.#context, gainDb)
  }

  /** The context in which all of it sounds. */
  context = (): BaseAudioContext => this.#contextNow()

  /** Where the listener is: the position, but for what the device is late. */
  heardS = (): number => this.#placeOf((voice) => voice.heardS())

  /** Whether what plays has come to the listener. */
  isHeard = (): boolean => this.#voice?.isHeard() ?? false

  /** Hear everything through other nodes, or directly. What sounds goes on without a gap, at the same position. */
  setOutput(makeOutput: MakeOutput = direct): void {
    this.#mix.setOutput(this.#context, makeOutput, this.#set !== null || this.#voice !== null)
  }

  /** Play variations at random, never the same twice running, as often and as evenly as `way` says, until `pause`. */
  async playRandomized(sources: readonly Source[], way: SetPlaybackMode = IN_ORDER): Promise<void> {
    if (sources.length === 0) return
    const asked = ++this.#asked
    const context = this.#contextNow()
    if (context.state === 'suspended') void context.resume()
    this.#stopSet()
    this.#silence()
    this.#notify({ status: 'loading', error: null })
    const read = await Promise.all(sources.map((source) => this.#read(source, asked, 'get')))
    const buffers = read.flatMap((buffer) => buffer ?? [])
    if (asked !== this.#asked || buffers.length < sources.length) return
    const { reversed } = this.#store.state
    const playback = new SetPlayback({
      context,
      to: this.#mix.input(context),
      buffers: reversed ? buffers.map((buffer) => this.previews.reversed(buffer, context)) : buffers,
      way,
      random: this.#random,
      gainOf: (index) => (sources[index] ? this.#gainOf(sources[index]) : 1),
    })
    this.#set = { sources, playback }
    this.#mix.announce('begins')
    this.#notify({ isRandomized: true, status: 'playing' })
    this.#followSet()
    this.#tick()
  }

  dispose(): void {
    this.pause()
    void this.#context?.close()
    this.#context = null
    this.#mix.clear()
    this.previews.clear()
  }

  /** Take into the hand what of the set began last. */
  #followSet(): void {
    const set = this.#set
    const hit = set?.playback.current()
    const source = hit && set?.sources[hit.index]
    if (!hit || !source || this.#voice?.node === hit.node) return
    this.#source = source
    this.#voice = new Voice(this.#contextNow(), { ...hit, fromS: 0, atS: hit.startsAtS })
    this.#notify({ sourceId: source.id, takeId: source.takeId ?? null, durationS: hit.buffer.duration })
  }

  #contextNow(): AudioContext {
    this.#context ??= this.#createContext()
    return this.#context
  }

  /** The sound itself; null where another was asked for meanwhile, or it could not be loaded. */
  async #read(
    { url, place }: Source,
    asked: number,
    how: 'first' | 'select' | 'get',
    excerpt: Wanted | null = null,
  ): Promise<AudioBuffer | null> {
    try {
      const buffer = await (excerpt ? this.previews.beginning(url, excerpt) : this.previews[how](url))
      if (asked !== this.#asked) return null
      this.#notify({ isLight: !this.previews.has(url) })
      return place?.(buffer, this.#contextNow()) ?? buffer
    } catch {
      if (asked !== this.#asked) return null
      this.#silence()
      this.#notify({ status: 'paused', error: 'The sound could not be loaded. Press Play to try again.' })
      return null
    }
  }

  /** Wait where it is for more of the sound. */
  #onBufferUnderrun(positionS: number): void {
    const { fromStart } = this.#store.state
    this.#silence()
    this.#moved(positionS)
    void this.play(positionS)
    this.#notify({ fromStart })
  }

  /** Put more of the sound, or the exact sound, in the place of what is heard: at the same sample, without a gap. */
  #onHigherQualityReady = (url: string, buffer: AudioBuffer): void => {
    const source = this.#source
    if (source?.url !== url) return
    const isLightHeard = this.#store.state.isLight && this.previews.has(url)
    if (isLightHeard) this.#notify({ isLight: false })
    if (this.#voice === null || this.#set !== null) return
    if (!isLightHeard && !this.previews.isBeginning(this.#voice.buffer)) return
    this.#takeOver(source.place?.(buffer, this.#contextNow()) ?? buffer, source)
  }

  /** Go on from there where something sounded; else stand there. */
  #soundOrMove(buffer: AudioBuffer | undefined, positionS: number): void {
    if (buffer && this.#source) this.#sound(this.previews.forwardsOf(buffer), this.#source, positionS)
    else this.#moved(positionS)
  }

  /** Sound in the place of what sounds now, at the same moment of it, or so much later. */
  #takeOver(buffer: AudioBuffer, source: Source, laterS = 0): void {
    const atS = Math.max(soonS(this.#contextNow()), this.#voice?.settledAtS ?? 0)
    this.#sound(buffer, source, Math.max(0, this.#placeOf((voice) => voice.positionS(atS)) + laterS), atS)
  }

  #sound(given: AudioBuffer, source: Source, positionS: number, joinsAtS?: number): void {
    this.previews.release()
    const context = this.#contextNow()
    const [atS, joins] = [joinsAtS ?? soonS(context), joinsAtS !== undefined]
    const { reversed } = this.#store.state
    const untilS = this.previews.untilS(given)
    if (this.previews.isBeginning(given) && (reversed || positionS >= untilS)) {
      this.#onBufferUnderrun(positionS)
      return
    }
    const buffer = reversed ? this.previews.reversed(given, context) : given
    const loop = loopOf(this.#store.state, buffer.duration)
    let fromS = Math.min(buffer.duration, Math.max(0, reversed ? buffer.duration - positionS : positionS))
    if (loop && (fromS < loop.startS || fromS >= loop.endS)) fromS = loop.startS
    if (fromS >= buffer.duration) {
      this.#silence({ alone: true, atS })
      this.#ended()
      return
    }

    const [to, gain, goesOn] = [this.#mix.input(context), this.#gainOf(source), this.isPlaying()]
    const voice = Voice.start(context, { to, buffer, gain, loop, fromS, untilS, atS, goesOn, joins })
    this.#silence({ alone: true, atS: voice.startsAtS })
    this.#mix.announce('begins')
    voice.onEnded(() => {
      if (this.#voice !== voice) return
      if (this.previews.isBeginning(buffer)) this.#onBufferUnderrun(untilS)
      else this.#ended()
    })
    this.#voice = voice
    this.#beginCompany(voice, voice.startsAtS)
    this.#notify({ status: 'playing' })
    this.#tick()
  }

  /** Have the others sound from where the source is at a time of the context. */
  #beginCompany(voice: Voice, atS = this.#contextNow().currentTime): void {
    const [context, loop] = [this.#contextNow(), loopOf(this.#store.state, voice.buffer.duration)]
    this.#backingTracks.begin(this.#mix.input(context), { context, atS, fromS: voice.positionS(atS), loop })
  }

  #endCompany(): void {
    this.#backingTracks.end((this.#context?.currentTime ?? 0) + FADE_S)
  }

  #ended(): void {
    const { durationS, reversed } = this.#store.state
    this.#voice = null
    this.#endCompany()
    this.#mix.announce('is over')
    this.#notify({ status: 'paused' })
    this.#moved(reversed ? 0 : durationS)
  }

  /** Stop what sounds, with a fade that is too short to hear. */
  #silence({ alone = false, atS = this.#context?.currentTime ?? 0 } = {}): void {
    const voice = this.#voice
    if (voice === null) return
    if (!alone) this.#endCompany()
    this.#positionS = this.positionS()
    this.#voice = null
    voice.stop(atS)
    this.#mix.announce('pauses')
    this.#playhead.stop()
  }

  #gainOf(source: Source): number {
    if (this.#hushed) return 0
    return this.#store.state.matched ? 10 ** ((source.matchGainDb ?? 0) / 20) : 1
  }

  /** Where in the sound something is that is asked of its voice. */
  #placeOf(asked: (voice: Voice) => number): number {
    if (this.#voice === null) return this.#positionS
    const at = asked(this.#voice)
    return this.#store.state.reversed ? this.#voice.buffer.duration - at : at
  }

  #change(change: Partial<PlayerState>): void {
    const voice = this.#voice
    if (voice === null || this.#source === null || this.#set !== null) {
      this.#notify(change)
      return
    }
    const at = voice.positionS()
    const positionS = this.positionS()
    this.#notify(change)
    const loop = loopOf(this.#store.state, voice.buffer.duration)
    if (loop && (at < loop.startS || at >= loop.endS)) {
      this.#sound(this.previews.forwardsOf(voice.buffer), this.#source, positionS)
      return
    }
    voice.setLoop(loop)
    this.#beginCompany(voice)
  }

  #stopSet(): void {
    if (this.#set === null) return
    this.#set.playback.stop()
    this.#set = null
    this.#silence()
    this.#notify({ isRandomized: false })
  }

  #moved(positionS: number): void {
    this.#positionS = positionS
    this.#playhead.step()
  }

  #tick(): void {
    this.#playhead.start(() => {
      this.#followSet()
      return this.isPlaying()
    })
  }

  #notify(change: Partial<PlayerState>): void {
    this.#store.change(change)
  }
}
