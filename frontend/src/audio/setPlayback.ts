import { type Hit, hitsOf, type SetPlaybackMode } from './setSchedule'

/** So far ahead times are handed to the context: a page in the background is woken once a second. */
const AHEAD_S = 1.5
const WAKE_MS = 200
const FADE_S = 0.005

/** One time that a variation is played, on its way to the listener. */
export interface PlayedHit extends Hit {
  node: AudioBufferSourceNode
  gain: GainNode
  buffer: AudioBuffer
  startsAtS: number
}

interface Played {
  context: AudioContext
  to: AudioNode
  buffers: readonly AudioBuffer[]
  way: SetPlaybackMode
  random: () => number
  /** How loud a variation is, before the game strays from it. */
  gainOf: (index: number) => number
}

/** A set played by the context's own clock, until it is stopped. */
export class SetPlayback {
  /** All of it passes here. */
  readonly bus: GainNode
  readonly #played: Played
  readonly #hits: Generator<Hit, never>
  readonly #beganAtS: number
  #next: Hit
  #started: PlayedHit[] = []
  #timer: ReturnType<typeof setTimeout> | undefined

  constructor(played: Played) {
    const { context, to, buffers, way, random } = played
    this.#played = played
    this.bus = context.createGain()
    this.bus.connect(to)
    this.#beganAtS = context.currentTime
    const lengthsS = buffers.map(({ duration }) => duration)
    this.#hits = hitsOf(lengthsS, way, random)
    this.#next = this.#hits.next().value
    this.#schedule()
  }

  /** The one that began last. */
  current(): PlayedHit | undefined {
    const now = this.#played.context.currentTime
    return this.#started.findLast(({ startsAtS }) => startsAtS <= now)
  }

  stop(): void {
    clearTimeout(this.#timer)
    const now = this.#played.context.currentTime
    this.bus.gain.setValueAtTime(1, now)
    this.bus.gain.linearRampToValueAtTime(0, now + FADE_S)
    for (const { node } of this.#started) node.stop(now + FADE_S)
  }

  #schedule(): void {
    const { context, buffers, gainOf } = this.#played
    const until = context.currentTime + AHEAD_S
    while (this.#beganAtS + this.#next.atS < until) {
      const hit = this.#next
      this.#next = this.#hits.next().value
      const buffer = buffers[hit.index]
      if (!buffer) continue
      const node = context.createBufferSource()
      const gain = context.createGain()
      node.buffer = buffer
      node.playbackRate.value = hit.speed
      node.connect(gain)
      gain.connect(this.bus)
      // Its time may have passed while the page was held up.
      const startsAtS = Math.max(context.currentTime, this.#beganAtS + hit.atS)
      gain.gain.setValueAtTime(gainOf(hit.index) * 10 ** (hit.gainDb / 20), startsAtS)
      node.start(startsAtS, 0)
      this.#started.push({ ...hit, node, gain, buffer, startsAtS })
    }
    this.#forget()
    this.#timer = setTimeout(() => this.#schedule(), WAKE_MS)
  }

  /** Let go of what is over, but for the one that began last. */
  #forget(): void {
    const now = this.#played.context.currentTime
    const last = this.current()
    this.#started = this.#started.filter((hit) => hit === last || hit.startsAtS + hit.buffer.duration / hit.speed > now)
  }
}
