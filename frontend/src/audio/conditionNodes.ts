import type { Condition, Crossfeed, NoiseBed, Stage } from './conditions'
import { noiseBed } from './noise'
import type { MakeOutput } from './output'

/** The Q of each second-order part of a Butterworth filter: 1 / (2·cos θ) for its pairs of poles. */
const QS = { 2: [Math.SQRT1_2], 4: [0.541196, 1.306563] } as const
const NOISE_IN_S = 0.05
const NOISE_OUT_S = 0.3
/** A short sound is over before the noise is heard: it stays so long after it. */
const NOISE_STAYS_S = 0.7

interface Part {
  input: AudioNode
  output: AudioNode
}

/** Build the filters and the noise of a listening condition. */
export function outputOf({ stages, noise, headroomDb }: Condition): MakeOutput {
  return (context) => {
    const input = context.createGain()
    const level = context.createGain()
    const gain = context.createGain()
    level.gain.value = 10 ** (headroomDb / 20)
    const parts = stages.map((stage) => partOf(stage, context))
    const last = parts.reduce<AudioNode>((before, part) => {
      before.connect(part.input)
      return part.output
    }, input)
    last.connect(level)
    level.connect(gain)
    gain.connect(context.destination)
    const bed = noise && startNoise(noise, context, level)
    return {
      input,
      gain,
      onSounding: bed?.onSounding,
      remove: () => {
        bed?.stop()
        gain.disconnect()
      },
    }
  }
}

function partOf(stage: Stage, context: BaseAudioContext): Part {
  if (stage.kind === 'mono') {
    const sum = context.createGain()
    sum.channelCount = 1
    sum.channelCountMode = 'explicit'
    return { input: sum, output: sum }
  }
  if (stage.kind === 'crossfeed') return crossfeedOf(stage, context)
  const filters = QS[stage.order].map((q) => {
    const filter = context.createBiquadFilter()
    filter.type = stage.kind
    filter.frequency.value = stage.hz
    filter.Q.value = 20 * Math.log10(q) // of these two kinds Web Audio takes Q in dB
    return filter
  })
  for (const [index, filter] of filters.entries()) {
    const next = filters[index + 1]
    if (next) filter.connect(next)
  }
  const [first] = filters
  const last = filters.at(-1)
  if (!first || !last) throw new Error('a filter without a part')
  return { input: first, output: last }
}

function crossfeedOf({ hz, levelDb, delayS }: Crossfeed, context: BaseAudioContext): Part {
  const ratio = 10 ** (levelDb / 20)
  const share = ratio / (1 + ratio) // of the lows; what stays is 1 − share, and their ratio is `levelDb`
  const input = context.createGain()
  input.channelCount = 2
  input.channelCountMode = 'explicit'
  const split = context.createChannelSplitter(2)
  const merged = context.createChannelMerger(2)
  input.connect(split)
  for (const [own, other] of [
    [0, 1],
    [1, 0],
  ] as const) {
    const low = firstOrderLowPass(hz, context)
    const leaves = context.createGain()
    leaves.gain.value = -share
    const crosses = context.createGain()
    crosses.gain.value = share
    const later = context.createDelay(0.01)
    later.delayTime.value = Math.max(0, delayS - 1 / (2 * Math.PI * hz)) // the low-pass delays its lows by the rest
    split.connect(merged, own, own)
    split.connect(low, own)
    low.connect(leaves)
    leaves.connect(merged, 0, own)
    low.connect(later)
    later.connect(crosses)
    crosses.connect(merged, 0, other)
  }
  return { input, output: merged }
}

function firstOrderLowPass(hz: number, context: BaseAudioContext): IIRFilterNode {
  const k = Math.tan((Math.PI * hz) / context.sampleRate)
  return context.createIIRFilter([k / (1 + k), k / (1 + k)], [1, (k - 1) / (k + 1)])
}

function startNoise(noise: NoiseBed, context: BaseAudioContext, to: AudioNode) {
  const channels = noiseBed(noise, context.sampleRate)
  const buffer = context.createBuffer(2, channels[0].length, context.sampleRate)
  for (const [channel, samples] of channels.entries()) {
    buffer.copyToChannel(samples as Float32Array<ArrayBuffer>, channel)
  }
  const source = context.createBufferSource()
  source.buffer = buffer
  source.loop = true
  const heard = context.createGain()
  const { gain } = heard
  gain.value = 0
  source.connect(heard)
  heard.connect(to)
  source.start()
  return {
    onSounding: (change: 'begins' | 'pauses' | 'is over') => {
      const now = context.currentTime
      gain.cancelScheduledValues(now)
      gain.setValueAtTime(gain.value, now)
      if (change === 'begins') gain.linearRampToValueAtTime(1, now + NOISE_IN_S)
      else if (change === 'pauses') gain.linearRampToValueAtTime(0, now + NOISE_IN_S)
      else {
        gain.setValueAtTime(gain.value, now + NOISE_STAYS_S)
        gain.linearRampToValueAtTime(0, now + NOISE_STAYS_S + NOISE_OUT_S)
      }
    },
    stop: () => source.stop(),
  }
}
