import type { TimeRange } from './draw'
import { heardTimeS, isLate, soonS } from './schedule'

/** Long enough that a switch does not click, too short to hear as a fade. */
export const FADE_S = 0.005

/** Bring a gain to another value without a click, now, or at a time at which its value is known. */
export function ramp(
  { gain }: GainNode,
  { to, atS, from = gain.value, fadeS = FADE_S }: { to: number; atS: number; from?: number; fadeS?: number },
): void {
  gain.cancelScheduledValues(atS)
  gain.setValueAtTime(from, atS)
  gain.linearRampToValueAtTime(to, atS + fadeS)
}

/** A buffer that sounds, and where in it and when it began. */
export interface Started {
  node: AudioBufferSourceNode
  gain: GainNode
  buffer: AudioBuffer
  fromS: number
  /** By the clock of the context. */
  atS: number
  /** 2 where it is played an octave up. */
  speed: number
}

interface Fade {
  from: number
  to: number
  atS: number
}

interface Start {
  to: AudioNode
  buffer: AudioBuffer
  gain: number
  loop: TimeRange | null
  fromS: number
  /** Until where there is sound in the buffer. */
  untilS: number
  atS: number
  /** It is in the place of another at that time: later, it begins so much farther on. */
  goesOn: boolean
  /** What sounds until then is at the same place of the same moment. */
  joins: boolean
}

/** So often a start is tried again whose time was over before the device had it. */
const MOST_TRIES = 4

/** One buffer that sounds: its gain, its loop, and where in it the listener is. */
export class Voice {
  readonly node: AudioBufferSourceNode
  readonly buffer: AudioBuffer
  readonly #context: BaseAudioContext
  readonly #gain: GainNode
  readonly #speed: number
  #fromS: number
  #atS: number
  /** The fade that was scheduled last: what a node says of its gain before that is of no use. */
  #fade: Fade
  /** Something sounded at the same place until it began. */
  #joins = false

  constructor(context: BaseAudioContext, { node, gain, buffer, fromS, atS, speed }: Started) {
    this.#context = context
    this.node = node
    this.buffer = buffer
    this.#gain = gain
    this.#speed = speed
    this.#fromS = fromS
    this.#atS = atS
    this.#fade = { from: gain.gain.value, to: gain.gain.value, atS }
  }

  static start(context: AudioContext, start: Start): Voice {
    let voice = Voice.#schedule(context, start)
    for (let tries = 1; tries < MOST_TRIES && isLate(context, voice.startsAtS); tries += 1) {
      // The page was held up: nobody knows from which sample on the device plays it.
      const atS = soonS(context)
      voice.#discard()
      voice = Voice.#schedule(context, { ...start, atS, fromS: start.goesOn ? voice.positionS(atS) : start.fromS })
    }
    return voice
  }

  static #schedule(context: BaseAudioContext, start: Start): Voice {
    const { to, buffer, gain, loop, fromS, untilS, atS, joins } = start
    const node = context.createBufferSource()
    const fader = context.createGain()
    node.buffer = buffer
    node.connect(fader)
    fader.connect(to)
    // A start at the very beginning keeps its attack; anywhere else a short ramp keeps it from clicking. The node has
    // that gain from now on: what is set at a time may hold one sample after it.
    fader.gain.value = fromS === 0 ? gain : 0
    const voice = new Voice(context, { node, gain: fader, buffer, fromS, atS, speed: 1 })
    voice.#joins = joins
    voice.#fadeTo(gain, atS, fader.gain.value)
    voice.#repeat(loop)
    node.start(atS, fromS)
    if (untilS < buffer.duration) {
      const endsAtS = atS + untilS - fromS
      fader.gain.setValueAtTime(gain, Math.max(atS + FADE_S, endsAtS - FADE_S))
      fader.gain.linearRampToValueAtTime(0, endsAtS)
      node.stop(endsAtS)
    }
    return voice
  }

  get startsAtS(): number {
    return this.#atS
  }

  /** From when on it is as loud as it will be. */
  get settledAtS(): number {
    return this.#fade.atS + FADE_S
  }

  /** Where in the buffer it is at a time of the context. */
  positionS(nowS = this.#context.currentTime): number {
    const { loop, loopStart, loopEnd } = this.node
    const at = this.#fromS + this.#speed * Math.max(0, nowS - this.#atS)
    if (!loop) return Math.min(at, this.buffer.duration)
    if (at < loopEnd) return at
    return loopStart + ((at - loopStart) % (loopEnd - loopStart))
  }

  /** Where in the buffer the listener is; until it is heard, where it begins, or where what it joined is. */
  heardS(): number {
    const heardAtS = heardTimeS(this.#context)
    const beforeS = this.#joins ? Math.max(0, this.#atS - heardAtS) : 0
    return Math.max(0, this.positionS(heardAtS) - beforeS)
  }

  /** Whether the listener hears it yet, or what it joined. */
  isHeard(): boolean {
    return this.#joins || heardTimeS(this.#context) >= this.#atS
  }

  /** Repeat something else, or nothing: the sound goes on without a gap, only its reference time is reset. */
  setLoop(loop: TimeRange | null): void {
    this.#fromS = this.positionS()
    this.#atS = Math.max(this.#atS, this.#context.currentTime)
    this.#joins = true
    this.#repeat(loop)
  }

  setGain(gain: number): void {
    this.#fadeTo(gain, this.#context.currentTime)
  }

  onEnded(callback: () => void): void {
    this.node.onended = callback
  }

  /** Stop with a fade that is too short to hear. */
  stop(atS: number): void {
    this.node.onended = null
    this.#fadeTo(0, atS)
    this.node.stop(atS + FADE_S)
  }

  #fadeTo(to: number, atS: number, from = this.#gainAt(atS)): void {
    ramp(this.#gain, { from, to, atS })
    this.#fade = { from, to, atS }
  }

  #gainAt(atS: number): number {
    const done = Math.min(1, Math.max(0, (atS - this.#fade.atS) / FADE_S))
    return this.#fade.from + (this.#fade.to - this.#fade.from) * done
  }

  #discard(): void {
    this.#gain.disconnect()
    this.node.stop()
  }

  #repeat(loop: TimeRange | null): void {
    this.node.loop = loop !== null
    if (loop) {
      this.node.loopStart = loop.startS
      this.node.loopEnd = loop.endS
    }
  }
}
