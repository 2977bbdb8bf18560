import type { Peaks, Spectrogram } from '@/audio'

/** Sounds of our own making, so that the page of parts shows real shapes and plays them. */

const RATE = 48_000
const TAU = Math.PI * 2

/** The same noise at every visit. */
function noiseFrom(seed: number): () => number {
  let state = seed
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) | 0
    return state / 2 ** 31
  }
}

const decay = (t: number, attackS: number, fallS: number): number =>
  t < 0 ? 0 : Math.min(1, t / attackS) * Math.exp(-Math.max(0, t - attackS) / fallS)

function make(durationS: number, peak: number, at: (t: number, noise: () => number) => number): Float32Array {
  const noise = noiseFrom(7)
  const samples = Float32Array.from({ length: Math.round(durationS * RATE) }, (_, frame) => at(frame / RATE, noise))
  const loudest = samples.reduce((most, value) => Math.max(most, Math.abs(value)), 1e-9)
  return samples.map((value) => Math.max(-1, Math.min(1, (value / loudest) * peak)))
}

const hit = (pitch: number, fallS: number) => (t: number, noise: () => number) =>
  decay(t, 0.001, 0.02) * noise() +
  decay(t, 0.004, fallS) * Math.sin(TAU * (pitch * t - pitch * 0.3 * t * t)) +
  decay(t - 0.06, 0.03, fallS) * Math.sin(TAU * pitch * 2.76 * t) * (0.6 + 0.4 * Math.sin(TAU * 21 * t)) +
  decay(t, 0.01, fallS) * noise() * 0.35

export const SAMPLES = {
  shieldA: make(0.84, 0.9, hit(310, 0.2)),
  shieldB: make(0.91, 0.62, hit(190, 0.3)),
  shieldC: make(0.78, 0.8, hit(560, 0.11)),
  step: make(0.4, 0.5, (t, noise) => decay(t, 0.003, 0.03) * noise() + decay(t, 0.004, 0.05) * Math.sin(TAU * 88 * t)),
  hum: make(4, 0.28, (t, noise) => 0.6 * Math.sin(TAU * 61 * t) + 0.2 * noise() * (1 + 0.4 * Math.sin(TAU * 1.5 * t))),
  door: make(
    2.41,
    1.15,
    (t, noise) => decay(t - 0.412, 0.004, 0.4) * noise() + decay(t - 1.69, 0.003, 0.12) * noise() * 1.1,
  ),
}

export const lengthOf = (samples: Float32Array): number => samples.length / RATE

export function peaksOf(samples: Float32Array, points: number): Peaks {
  const peaks = { points, min: [] as number[], max: [] as number[], rms: [] as number[] }
  for (let point = 0; point < points; point += 1) {
    const part = samples.subarray(
      Math.floor((point * samples.length) / points),
      Math.floor(((point + 1) * samples.length) / points),
    )
    peaks.min.push(Math.round(part.reduce((least, value) => Math.min(least, value), 1) * 127))
    peaks.max.push(Math.round(part.reduce((most, value) => Math.max(most, value), -1) * 127))
    peaks.rms.push(Math.round(Math.sqrt(part.reduce((sum, value) => sum + value * value, 0) / part.length) * 127))
  }
  return peaks
}

/** Loudness of 64 bands, 60 Hz to 20 kHz, by one filter a band. */
export function spectrogramOf(samples: Float32Array, columns = 160, rows = 64): Spectrogram {
  const values = new Uint8Array(columns * rows)
  for (let column = 0; column < columns; column += 1) {
    const middle = Math.floor(((column + 0.5) * samples.length) / columns)
    for (let row = 0; row < rows; row += 1) {
      const hz = 20_000 * (60 / 20_000) ** (row / (rows - 1))
      const width = Math.min(320, Math.ceil((RATE / hz) * 6))
      let real = 0
      let imaginary = 0
      for (let offset = 0; offset < width; offset += 1) {
        const window = 0.5 - 0.5 * Math.cos((TAU * offset) / width)
        const value = (samples[middle - width / 2 + offset] ?? 0) * window
        real += value * Math.cos((TAU * hz * offset) / RATE)
        imaginary += value * Math.sin((TAU * hz * offset) / RATE)
      }
      const db = 20 * Math.log10((Math.hypot(real, imaginary) / width) * 4 + 1e-9)
      values[row * columns + column] = Math.max(0, Math.min(255, ((db + 72) / 72) * 255))
    }
  }
  return { columns, rows, values }
}

/** A WAV of 16 bit to play, as an address. */
export function addressOf(samples: Float32Array): string {
  const view = new DataView(new ArrayBuffer(44 + samples.length * 2))
  const text = (at: number, letters: string) =>
    [...letters].forEach((letter, index) => view.setUint8(at + index, letter.charCodeAt(0)))
  text(0, 'RIFF')
  view.setUint32(4, 36 + samples.length * 2, true)
  text(8, 'WAVEfmt ')
  view.setUint32(16, 16, true)
  view.setUint16(20, 1, true)
  view.setUint16(22, 1, true)
  view.setUint32(24, RATE, true)
  view.setUint32(28, RATE * 2, true)
  view.setUint16(32, 2, true)
  view.setUint16(34, 16, true)
  text(36, 'data')
  view.setUint32(40, samples.length * 2, true)
  samples.forEach((value, index) => view.setInt16(44 + index * 2, Math.round(value * 32_767), true))
  return URL.createObjectURL(new Blob([view], { type: 'audio/wav' }))
}
