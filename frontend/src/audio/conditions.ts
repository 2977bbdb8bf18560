/**
 * How a sound is likely to be played, each as filters in figures. No filter imitates one device: each keeps what most of
 * its kind have in common. `from` says where the figures come from, and where they are our own choice.
 */

/** Butterworth: at `hz` the level is 3.01 dB down; each order is 6 dB an octave. */
interface Edge {
  kind: 'highpass' | 'lowpass'
  hz: number
  order: 2 | 4
}

/** Both channels summed at half each, so that what is the same in both keeps its level. */
interface Mono {
  kind: 'mono'
}

/**
 * Below `hz` (first order) a part of each channel goes to the other ear, as from two loudspeakers; it leaves its own in
 * the same measure, so that what is in the middle sounds as before.
 */
export interface Crossfeed {
  kind: 'crossfeed'
  hz: number
  /** How much lower the other ear hears it than its own, at the lowest frequencies. */
  levelDb: number
  /** How much later than it was sent, at the lowest frequencies; the low-pass makes most of it. */
  delayS: number
}

export type Stage = Edge | Mono | Crossfeed

/** Noise around the listener, by octaves. It sounds while something plays. */
export interface NoiseBed {
  /** The level of each octave: its middle in Hz, and dBFS (RMS, of a sine at full scale −3.01). */
  octaves: readonly { hz: number; dbfs: number }[]
  seed: number
}

export interface Condition {
  id: string
  /** After "Heard as": "phone". */
  name: string
  /** "mono, 700 Hz to 12 kHz". */
  figures: string
  stages: readonly Stage[]
  noise?: NoiseBed
  /** Sound and noise are played so much lower that their sum stays below full scale for a true peak of −1 dBTP. */
  headroomDb: number
}

/** Digital level at which a small room is set to 76 dB SPL: ATSC A/85, table of reference levels by room volume. */
const SPL_AT_0_DBFS = 76 + 20

/** Octave levels of the noise rating curve `nr`, a + b·NR (ISO R 1996:1971), played at the level of a small room. */
function ratedNoise(nr: number, fromHz: number): NoiseBed['octaves'] {
  const curve = [
    [63, 35.4, 0.79],
    [125, 22, 0.87],
    [250, 12, 0.93],
    [500, 4.8, 0.974],
    [1000, 0, 1],
    [2000, -3.5, 1.015],
    [4000, -6.1, 1.025],
    [8000, -8, 1.03],
  ] as const
  return curve.filter(([hz]) => hz >= fromHz).map(([hz, a, b]) => ({ hz, dbfs: a + b * nr - SPL_AT_0_DBFS }))
}

export const CONDITIONS: readonly Condition[] = [
  // Web Audio API, mixing rules of the interpretation "speakers": 0.5 · (L + R).
  {
    id: 'mono',
    name: 'mono',
    figures: 'both channels summed',
    stages: [{ kind: 'mono' }],
    headroomDb: 0,
  },
  // A driver in a closed box falls by 12 dB an octave below its resonance (Small, Closed-Box Loudspeaker Systems,
  // JAES 1972). 700 Hz and 12 kHz are our choice for the loudspeaker of a phone.
  {
    id: 'phone',
    name: 'phone',
    figures: 'mono, 700 Hz to 12 kHz',
    stages: [{ kind: 'mono' }, { kind: 'highpass', hz: 700, order: 2 }, { kind: 'lowpass', hz: 12_000, order: 2 }],
    headroomDb: 0,
  },
  // A vented box falls by 24 dB an octave (Small, Vented-Box Loudspeaker Systems, JAES 1973). 150 Hz and 15 kHz
  // are our choice for the loudspeakers of a flat television.
  {
    id: 'television',
    name: 'television',
    figures: 'stereo, 150 Hz to 15 kHz',
    stages: [
      { kind: 'highpass', hz: 150, order: 4 },
      { kind: 'lowpass', hz: 15_000, order: 2 },
    ],
    headroomDb: 0,
  },
  // A closed box, as above. 120 Hz and 12 kHz are our choice for one driver of 10 to 13 cm without a tweeter.
  {
    id: 'small',
    name: 'small speaker',
    figures: 'mono, 120 Hz to 12 kHz',
    stages: [{ kind: 'mono' }, { kind: 'highpass', hz: 120, order: 2 }, { kind: 'lowpass', hz: 12_000, order: 2 }],
    headroomDb: 0,
  },
  // Bauer stereophonic-to-binaural (bs2b), default preset: 700 Hz, 260 µs, 4.5 dB.
  {
    id: 'headphones',
    name: 'headphones',
    figures: 'crossfeed below 700 Hz, 4.5 dB lower and 0.26 ms later',
    stages: [{ kind: 'crossfeed', hz: 700, levelDb: -4.5, delayS: 260e-6 }],
    headroomDb: 0,
  },
  // Noise rating curve NR 20, about 30 dB(A): the limit of the WHO Guidelines for Community Noise for bedrooms.
  {
    id: 'quiet-room',
    name: 'quiet room',
    figures: 'noise of a bedroom, NR 20',
    stages: [],
    noise: { octaves: ratedNoise(20, 63), seed: 20 },
    headroomDb: 0,
  },
  // Noise rating curve NR 60 from 125 Hz up, about 67 dB(A). The curve and its rating are our choice for the
  // inside of a coach.
  {
    id: 'train',
    name: 'train',
    figures: 'noise of a coach, NR 60; all 4 dB lower',
    stages: [],
    noise: { octaves: ratedNoise(60, 125), seed: 60 },
    headroomDb: -4,
  },
]
