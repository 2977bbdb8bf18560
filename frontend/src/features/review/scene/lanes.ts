import type { Company, CompanyStart } from '@/audio'
import type { Placing } from '@/verdicts/useHearing'

/** Long enough that a change of level does not click, too short to hear as a fade. */
const FADE_S = 0.005
/** Closer than this two positions are one: what sounds goes on. */
const SAME_S = 0.002

/** When a sound plays in a scene, and how loud. */
export interface Places {
  startsS: readonly number[]
  loops: boolean
  lengthS: number
}

/** A sound over the length of a scene: from each start once, or without an end from its first. */
export function placed(sound: AudioBuffer, context: BaseAudioContext, places: Places, levelDb = 0): AudioBuffer {
  const rate = sound.sampleRate
  const length = Math.max(1, Math.round(places.lengthS * rate))
  const whole = context.createBuffer(sound.numberOfChannels, length, rate)
  const gain = 10 ** (levelDb / 20)
  for (let channel = 0; channel < sound.numberOfChannels; channel += 1) {
    const from = sound.getChannelData(channel)
    const to = whole.getChannelData(channel)
    for (const startS of places.startsS) {
      const first = Math.round(startS * rate)
      const end = places.loops ? length : Math.min(length, first + from.length)
      for (let frame = first; frame < end; frame += 1) {
        to[frame] = (to[frame] ?? 0) + gain * (from[(frame - first) % from.length] ?? 0)
      }
    }
  }
  return whole
}

/** What places the version that is heard; each of its alternates once. */
export function placingOf(places: Places, levelDb: number): Placing {
  const known = new WeakMap<AudioBuffer, AudioBuffer>()
  return {
    startS: places.loops ? 0 : (places.startsS[0] ?? 0),
    place: (sound, context) => {
      const there = known.get(sound) ?? placed(sound, context, places, levelDb)
      known.set(sound, there)
      return there
    },
  }
}

/** One sound beside the version, over the length of the scene. */
export interface HeardLane {
  id: string
  buffer: AudioBuffer
  levelDb: number
  isOn: boolean
}

interface Sounding {
  lane: HeardLane
  node: AudioBufferSourceNode
  gain: GainNode
}

/** All that sounds beside a version, from the same sample on and round the same loop. */
export class SceneLanes implements Company {
  #lanes: readonly HeardLane[] = []
  #start: CompanyStart | null = null
  #sounding = new Map<string, Sounding>()

  /** Hear these lanes: a changed level is faded, a new sound joins where the others are. */
  set(lanes: readonly HeardLane[]): void {
    this.#lanes = lanes
    if (this.#start === null) return
    const { context } = this.#start
    const lanesById = new Map(lanes.map((lane) => [lane.id, lane]))
    for (const [id, { lane, node, gain }] of this.#sounding) {
      if (lanesById.get(id)?.buffer === lane.buffer) continue
      ramp(gain, 0, context)
      node.stop(context.currentTime + FADE_S)
      this.#sounding.delete(id)
    }
    for (const lane of lanes) {
      const sounding = this.#sounding.get(lane.id)
      if (sounding) ramp(sounding.gain, gainOf(lane), context)
      else this.#sound(lane, { ...this.#start, atS: context.currentTime, fromS: this.#positionS() })
    }
  }

  begin(start: CompanyStart): void {
    if (this.#start && this.#start.to === start.to && Math.abs(this.#positionS(start.atS) - start.fromS) < SAME_S) {
      for (const { node } of this.#sounding.values()) loopRound(node, start.loop)
      this.#start = start
      return
    }
    this.end(start.atS + FADE_S)
    this.#start = start
    for (const lane of this.#lanes) this.#sound(lane, start)
  }

  end(atS: number): void {
    if (this.#start === null) return
    for (const { node, gain } of this.#sounding.values()) {
      ramp(gain, 0, this.#start.context)
      node.stop(atS)
    }
    this.#sounding.clear()
    this.#start = null
  }

  #sound(lane: HeardLane, { context, to, atS, fromS, loop }: CompanyStart): void {
    const node = context.createBufferSource()
    const gain = context.createGain()
    node.buffer = lane.buffer
    loopRound(node, loop)
    node.connect(gain)
    gain.connect(to)
    gain.gain.setValueAtTime(fromS === 0 ? gainOf(lane) : 0, atS)
    gain.gain.linearRampToValueAtTime(gainOf(lane), atS + FADE_S)
    node.start(atS, fromS)
    this.#sounding.set(lane.id, { lane, node, gain })
  }

  #positionS(now = this.#start?.context.currentTime ?? 0): number {
    if (this.#start === null) return 0
    const { atS, fromS, loop } = this.#start
    const at = fromS + Math.max(0, now - atS)
    return loop && at >= loop.endS ? loop.startS + ((at - loop.startS) % (loop.endS - loop.startS)) : at
  }
}

/** How loud a lane plays; 0 while it is muted. */
export const gainOf = ({ isOn, levelDb }: HeardLane): number => (isOn ? 10 ** (levelDb / 20) : 0)

function loopRound(node: AudioBufferSourceNode, loop: CompanyStart['loop']): void {
  node.loop = loop !== null
  if (loop === null) return
  node.loopStart = loop.startS
  node.loopEnd = loop.endS
}

function ramp({ gain }: GainNode, to: number, { currentTime: now }: BaseAudioContext): void {
  gain.cancelScheduledValues(now)
  gain.setValueAtTime(gain.value, now)
  gain.linearRampToValueAtTime(to, now + FADE_S)
}
