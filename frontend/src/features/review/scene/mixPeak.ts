/** No mix rises over this: a decibel below full scale, as levels are matched to. */
const PEAK_LIMIT_DBTP = -1

const OVERSAMPLING = 4
/** Samples on either side that shape the curve between two of them. */
const HALF_TAPS = 12
const BLOCK_FRAMES = 256

/** One sound of a mix, over the whole length of the scene. */
export interface MixPart {
  buffer: AudioBuffer
  gain: number
}

/** How far everything has to come down so that none of the mixes rises over −1 dBTP; 0 where none does. */
export function loweringDb(mixes: readonly (readonly MixPart[])[]): number {
  const peak = Math.max(0, ...mixes.map(mixPeak))
  return peak > 0 ? Math.max(0, 20 * Math.log10(peak) - PEAK_LIMIT_DBTP) : 0
}

/** The true peak of sounds that play together, as a share of full scale. */
export function mixPeak(parts: readonly MixPart[]): number {
  const heard = parts.filter(({ gain }) => gain > 0)
  const channels = Math.max(1, ...heard.map(({ buffer }) => buffer.numberOfChannels))
  return Math.max(0, ...Array.from({ length: channels }, (_, channel) => truePeak(summed(heard, channel))))
}

/** One channel of the mix; a mono sound is in both, as it is heard. */
function summed(parts: readonly MixPart[], channel: number): Float32Array {
  const sum = new Float32Array(Math.max(0, ...parts.map(({ buffer }) => buffer.length)))
  for (const { buffer, gain } of parts) {
    const samples = buffer.getChannelData(Math.min(channel, buffer.numberOfChannels - 1))
    for (let frame = 0; frame < samples.length; frame += 1)
      sum[frame] = (sum[frame] ?? 0) + gain * (samples[frame] ?? 0)
  }
  return sum
}

/** By phase between two samples: what the samples around add to the curve there, a sinc under a Hann window. */
const PHASES = Array.from({ length: OVERSAMPLING - 1 }, (_, phase) =>
  Float32Array.from({ length: 2 * HALF_TAPS }, (_, tap) => {
    const away = tap - HALF_TAPS + 1 - (phase + 1) / OVERSAMPLING
    return (Math.sin(Math.PI * away) / (Math.PI * away)) * Math.cos((Math.PI * away) / (2 * HALF_TAPS)) ** 2
  }),
)
/** The curve rises no further above the samples around it than by this factor. */
const STEEPEST = Math.max(...PHASES.map((taps) => taps.reduce((sum, tap) => sum + Math.abs(tap), 0)))

/** The highest point of the curve that runs through samples, ITU-R BS.1770 Annex 2: four points a sample. */
export function truePeak(samples: Float32Array): number {
  const tops: number[] = []
  for (let first = 0; first < samples.length; first += BLOCK_FRAMES) {
    let top = 0
    const end = Math.min(samples.length, first + BLOCK_FRAMES)
    for (let frame = first; frame < end; frame += 1) top = Math.max(top, Math.abs(samples[frame] ?? 0))
    tops.push(top)
  }
  let peak = Math.max(0, ...tops)
  // Loudest first: the rest cannot rise above what is found, and is left out.
  const reach = tops.map((top, at) => STEEPEST * Math.max(tops[at - 1] ?? 0, top, tops[at + 1] ?? 0))
  const order = reach.map((_, at) => at).sort((a, b) => (reach[b] ?? 0) - (reach[a] ?? 0))
  for (const at of order) {
    if ((reach[at] ?? 0) <= peak) break
    peak = Math.max(peak, curveTop(samples, at * BLOCK_FRAMES))
  }
  return peak
}

function curveTop(samples: Float32Array, first: number): number {
  let top = 0
  const end = Math.min(samples.length, first + BLOCK_FRAMES)
  for (let frame = first; frame < end; frame += 1) {
    for (const taps of PHASES) {
      let value = 0
      for (let tap = 0; tap < taps.length; tap += 1) {
        value += (taps[tap] ?? 0) * (samples[frame + tap - HALF_TAPS + 1] ?? 0)
      }
      top = Math.max(top, Math.abs(value))
    }
  }
  return top
}
