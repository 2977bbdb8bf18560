import type { NoiseBed } from './conditions'
import { seeded } from './random'

/** 2.7 s at 48 kHz: a power of two, and long enough that nobody hears it come round. */
const FRAMES = 2 ** 17

/**
 * Noise with stated octave levels, in two independent channels that repeat without a seam.
 *
 * It is drawn as a spectrum: in each octave all lines are equally strong, with phases from the seeded generator.
 */
export function noiseBed({ octaves, seed }: NoiseBed, sampleRateHz: number): [Float32Array, Float32Array] {
  const random = seeded(seed)
  const re = new Float64Array(FRAMES)
  const im = new Float64Array(FRAMES)
  for (const { hz, dbfs } of octaves) {
    const first = Math.ceil((hz * Math.SQRT1_2 * FRAMES) / sampleRateHz)
    const end = Math.min(FRAMES / 2, Math.ceil((hz * Math.SQRT2 * FRAMES) / sampleRateHz))
    // Each line is a cosine of amplitude a: the mean square of all is lines · a² / 2.
    const amplitude = 10 ** (dbfs / 20) * Math.sqrt(2 / (end - first))
    for (let line = first; line < end; line += 1) {
      // Left and right are the real and the imaginary part of one sum of rotating lines.
      const left = 2 * Math.PI * random()
      const right = 2 * Math.PI * random()
      const half = amplitude / 2
      re[line] = half * (Math.cos(left) - Math.sin(right))
      im[line] = half * (Math.sin(left) + Math.cos(right))
      re[FRAMES - line] = half * (Math.cos(left) + Math.sin(right))
      im[FRAMES - line] = half * (Math.cos(right) - Math.sin(left))
    }
  }
  transform(re, im)
  return [Float32Array.from(re), Float32Array.from(im)]
}

/** The sum of rotating lines at every frame, in place: the inverse Fourier transform without its divisor. */
function transform(re: Float64Array, im: Float64Array): void {
  const size = re.length
  for (let index = 1, turned = 0; index < size; index += 1) {
    let bit = size >> 1
    for (; turned & bit; bit >>= 1) turned ^= bit
    turned ^= bit
    if (index < turned) {
      swap(re, index, turned)
      swap(im, index, turned)
    }
  }
  for (let length = 2; length <= size; length *= 2) {
    const half = length / 2
    const cosines = Float64Array.from({ length: half }, (_, at) => Math.cos((2 * Math.PI * at) / length))
    const sines = Float64Array.from({ length: half }, (_, at) => Math.sin((2 * Math.PI * at) / length))
    for (let start = 0; start < size; start += length) {
      for (let at = 0; at < half; at += 1) {
        const [even, odd] = [start + at, start + at + half]
        const [cosine, sine] = [cosines[at] as number, sines[at] as number]
        const [oddRe, oddIm] = [re[odd] as number, im[odd] as number]
        const turnedRe = oddRe * cosine - oddIm * sine
        const turnedIm = oddRe * sine + oddIm * cosine
        re[odd] = (re[even] as number) - turnedRe
        im[odd] = (im[even] as number) - turnedIm
        re[even] = (re[even] as number) + turnedRe
        im[even] = (im[even] as number) + turnedIm
      }
    }
  }
}

function swap(values: Float64Array, a: number, b: number): void {
  const held = values[a] as number
  values[a] = values[b] as number
  values[b] = held
}
