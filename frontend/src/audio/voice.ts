import type { TimeRange } from './draw'
import { isLate, soonS } from './schedule'

/** Long enough that a switch does not click, too short to hear as a fade. */
export const FADE_S = 0.005

/** Bring a gain to another value without a click. */
export function ramp(context: BaseAudioContext, gain: GainNode, to: number, fadeS = FADE_S, atS = context.currentTime) {
  gain.gain.cancelScheduledValues(atS)
  gain.gain.setValueAtTime(gain.gain.value, atS)
  gain.gain.linearRampToValueAtTime(to, atS + fadeS)
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

  constructor(context: BaseAudioContext, { node, gain, buffer, fromS, atS, speed }: Started) {
    this.#context = context
    this.node = node
    this.buffer = buffer
    this.#gain = gain
    this.#speed = speed
    this.#fromS = fromS
    this.#atS = atS
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

  static #schedule(context: BaseAudioContext, { to, buffer, gain, loop, fromS, untilS, atS }: Start): Voice {
    const node = context.createBufferSource()
    const fader = context.createGain()
    node.buffer = buffer
    node.connect(fader)
    fader.connect(to)
    // A start at the very beginning keeps its attack; anywhere else a short ramp keeps it from clicking.
    fader.gain.setValueAtTime(fromS === 0 ? gain : 0, atS)
    fader.gain.linearRampToValueAtTime(gain, atS + FADE_S)
    const voice = new Voice(context, { node, gain: fader, buffer, fromS, atS, speed: 1 })
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

  /** Where in the buffer it is at a time of the context. */
  positionS(nowS = this.#context.currentTime): number {
    const { loop, loopStart, loopEnd } = this.node
    const at = this.#fromS + this.#speed * Math.max(0, nowS - this.#atS)
    if (!loop) return Math.min(at, this.buffer.duration)
    if (at < loopEnd) return at
    return loopStart + ((at - loopStart) % (loopEnd - loopStart))
  }

  /** Repeat something else, or nothing: the sound goes on without a gap, only its reference time is reset. */
  setLoop(loop: TimeRange | null): void {
    this.#fromS = this.positionS()
    this.#atS = Math.max(this.#atS, this.#context.currentTime)
    this.#repeat(loop)
  }

  setGain(gain: number): void {
    ramp(this.#context, this.#gain, gain)
  }

  onEnded(callback: () => void): void {
    this.node.onended = callback
  }

  /** Stop with a fade that is too short to hear. */
  stop(atS: number): void {
    this.node.onended = null
    ramp(this.#context, this.#gain, 0, FADE_S, atS)
    this.node.stop(atS + FADE_S)
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
