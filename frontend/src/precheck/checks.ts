/** The checks that need only the header and the peaks, with the server's words; `vectors.json` holds them to it. */
import { autoFix } from './autoFix'
import type { CueLength, Finding, Subject } from './findings'
import { exactly, fixed, type Fraction, general, isMore, levelShown, minus, size, toNumber } from './numbers'
import type { Peaks } from './peaks'
import type { Layout } from './wav'

type Found = Partial<Finding> & Pick<Finding, 'code' | 'message' | 'fix'>

const byNearness = (accepted: readonly number[], value: number, isLarger = false): number => {
  const ordered = accepted.toSorted((a, b) => (isLarger ? b - a : a - b))
  return ordered.reduce((best, candidate) => (Math.abs(candidate - value) < Math.abs(best - value) ? candidate : best))
}
const ascending = (values: readonly number[]) => values.toSorted((a, b) => a - b)
const decibels = (ratio: number) => (ratio > 0 ? 20 * Math.log10(ratio) : -Infinity)
const peakOf = ({ channels }: Peaks) => decibels(channels.reduce((most, peak) => Math.max(most, peak), 0))
const durationOf = ({ frames, sampleRateHz }: Layout) => frames / sampleRateHz

/** A container that the spec does not list. */
export function otherThanAccepted(containerName: string, accepted: readonly string[], code: string): Found {
  return {
    code,
    message: `container ${containerName.toUpperCase()}, accepted ${accepted.join(', ').toUpperCase()}`,
    fix: `export the sound as ${(accepted[0] ?? '').toUpperCase()}`,
  }
}

function* container({ layout, spec }: Subject): Iterable<Found> {
  const accepted = spec.accept.containers
  if (accepted === null || accepted.includes(layout.container)) return
  yield otherThanAccepted(layout.container, accepted, 'container:not-accepted')
}

const ENCODINGS: Record<string, string> = {
  pcm: 'integer (PCM)',
  float: 'float',
  vorbis: 'Vorbis',
  opus: 'Opus',
  mp3: 'MP3',
}
const wordOf = (encoding: string) => ENCODINGS[encoding] ?? encoding

function* encoding({ layout, spec }: Subject): Iterable<Found> {
  const accepted = spec.accept.encodings ?? []
  const [first] = accepted
  if (first === undefined || accepted.includes(layout.encoding)) return
  const isCodec = first !== 'pcm' && first !== 'float'
  yield {
    code: 'encoding:not-accepted',
    message: `${wordOf(layout.encoding)} samples, accepted ${accepted.map(wordOf).join(' or ')}`,
    fix: isCodec ? `encode it again as ${wordOf(first)}` : `export with ${wordOf(first)} samples`,
  }
}

function* sampleRate({ layout: { sampleRateHz: rate }, spec }: Subject): Iterable<Found> {
  if (spec.accept.sample_rates_hz === null) return
  const accepted = ascending(spec.accept.sample_rates_hz)
  const [lowest = 0] = accepted
  if (accepted.includes(rate)) return
  const nearest = byNearness(accepted, rate)
  yield {
    code: 'sample-rate:not-accepted',
    message: `sample rate ${rate} Hz, accepted ${accepted.join(', ')} Hz`,
    fix:
      rate < lowest
        ? `export the session at ${lowest} Hz; do not convert this file up, which adds no quality`
        : `export the session at ${nearest} Hz`,
    measured: rate,
    limit: nearest,
    unit: 'Hz',
  }
}

function* bitDepth({ layout: { bitDepth: depth }, spec }: Subject): Iterable<Found> {
  if (spec.accept.bit_depths === null) return
  const accepted = ascending(spec.accept.bit_depths)
  const [lowest = 0] = accepted
  if (accepted.includes(depth)) return
  const nearest = byNearness(accepted, depth, true)
  yield {
    code: 'bit-depth:not-accepted',
    message: `bit depth ${depth} bit, accepted ${accepted.join(', ')} bit`,
    fix:
      depth < lowest
        ? `export the session at ${lowest} bit; padding this file with zeros adds no quality`
        : `export the session at ${nearest} bit${nearest < depth ? ', with dither' : ''}`,
    measured: depth,
    limit: nearest,
    unit: 'bit',
  }
}

interface Speakers {
  channels: number
  masks: readonly number[]
  words: string
}

const LAYOUTS: Record<string, Speakers> = {
  mono: { channels: 1, masks: [0x4], words: 'mono' },
  stereo: { channels: 2, masks: [0x3], words: 'stereo' },
  lcr: { channels: 3, masks: [0x7], words: 'left, right, centre' },
  quad: { channels: 4, masks: [0x33, 0x603], words: 'quad: two in front, two behind' },
  '5.0': { channels: 5, masks: [0x607, 0x37], words: '5.0' },
  '5.1': { channels: 6, masks: [0x60f, 0x3f], words: '5.1' },
  '7.1': { channels: 8, masks: [0x63f], words: '7.1' },
  '7.1.4': { channels: 12, masks: [0x2d63f], words: '7.1.4' },
  'ambisonic-1': { channels: 4, masks: [], words: 'ambisonics of order 1' },
  'ambisonic-2': { channels: 9, masks: [], words: 'ambisonics of order 2' },
  'ambisonic-3': { channels: 16, masks: [], words: 'ambisonics of order 3' },
}
const channelWords = (channels: number) =>
  channels === 1 ? 'mono' : channels === 2 ? 'stereo' : `${channels} channels`

/** The layouts that a header can mean. */
function layoutsOf({ channels, channelMask: mask, isAmbisonic }: Layout): string[] {
  const named = (holds: (speakers: Speakers) => boolean) =>
    Object.keys(LAYOUTS).filter((name) => LAYOUTS[name]!.channels === channels && holds(LAYOUTS[name]!))
  if (isAmbisonic) return named(({ masks }) => masks.length === 0)
  if (channels === 1) return ['mono']
  if (mask) return named(({ masks }) => masks.includes(mask))
  return channels === 2 ? ['stereo'] : named(({ masks }) => masks.length === 0)
}

const CUE_CHANNELS = { mono: 1, stereo: 2 }

function* channels({ layout, spec, length: asked }: Subject): Iterable<Found> {
  const { channels: counts, layouts } = spec.accept
  const ofCue = asked?.channels ? CUE_CHANNELS[asked.channels] : null
  if (ofCue !== null && !(counts?.length === 1 && counts[0] === ofCue)) {
    if (layout.channels === ofCue) return
    yield {
      code: 'channels:cue',
      message: `${channelWords(layout.channels)}, and the sound list asks for ${channelWords(ofCue)}`,
      fix: `export it from the session as ${channelWords(ofCue)}`,
      measured: layout.channels,
      limit: ofCue,
      unit: 'channels',
    }
  } else if (counts !== null && !counts.includes(layout.channels)) {
    const accepted = ascending(counts)
    const nearest = byNearness(accepted, layout.channels)
    yield {
      code: 'channels:not-accepted',
      message: `${channelWords(layout.channels)}, accepted ${accepted.map(channelWords).join(' or ')}`,
      fix: `export it from the session as ${channelWords(nearest)}`,
      measured: layout.channels,
      limit: nearest,
      unit: 'channels',
    }
  } else if (layouts !== null && !layoutsOf(layout).some((name) => layouts.includes(name))) {
    yield otherLayout(layout, layouts)
  }
}

function otherLayout(layout: Layout, layouts: readonly string[]): Found {
  const { channels: count, channelMask: mask, isAmbisonic } = layout
  const means = layoutsOf(layout)
  const masked = mask ? ` with the channel mask 0x${mask.toString(16)}` : ''
  const named = means.length > 0 ? ` as ${means.join(' or ')}` : masked
  const actual = count > 2 ? `${named}${mask || isAmbisonic ? '' : ' without a channel mask'}` : masked
  const same = layouts.filter((name) => LAYOUTS[name]?.channels === count)
  const words = (same.length > 0 ? same : layouts).map((name) => LAYOUTS[name]?.words ?? name).join(' or ')
  return {
    code: 'channels:layout',
    message: `${channelWords(count)}${actual}, accepted ${layouts.join(' or ')}`,
    fix: `export it as ${words}, with the layout written to the header`,
  }
}

const seconds = (length: Fraction) => `${fixed(toNumber(length), 3)} s`
const USUAL_FPS = 60

function* duration({ layout, spec, length: asked }: Subject): Iterable<Found> {
  const length = { over: BigInt(layout.frames), under: BigInt(layout.sampleRateHz) }
  const { min: low, max: high } = spec.accept.duration_s
  const measured = durationOf(layout)
  if (low !== null && isMore(exactly(low), length)) {
    yield {
      code: 'duration:short',
      message: `${seconds(length)}, at least ${general(low)} s accepted`,
      fix: 'check that the export holds the whole sound',
      measured,
      limit: low,
      unit: 's',
    }
  }
  if (high !== null && isMore(length, exactly(high))) {
    yield {
      code: 'duration:long',
      message: `${seconds(length)}, at most ${general(high)} s accepted`,
      fix: `shorten the sound by ${seconds(minus(length, exactly(high)))} or more`,
      measured,
      limit: high,
      unit: 's',
      start_s: high,
      end_s: measured,
    }
  }
  if (asked?.duration_min_s != null || asked?.duration_max_s != null) yield* againstBounds(length, asked)
  else if (asked?.duration_s != null) yield* againstRequest(length, asked.duration_s, asked)
}

function* againstBounds(length: Fraction, { duration_min_s: low, duration_max_s: high, length_locked }: CueLength) {
  const isShort = low !== null && isMore(exactly(low), length)
  const limit = isShort ? low : high
  if (limit === null || !(isShort || isMore(length, exactly(limit)))) return
  const asked =
    low === null || high === null
      ? `${low === null ? 'at most' : 'at least'} ${general(low ?? high ?? 0)} s`
      : `${general(low)} to ${general(high)} s`
  yield {
    code: 'duration:bounds',
    message: `${seconds(length)} long; the sound list asks for ${asked}`,
    fix: `${isShort ? 'lengthen' : 'shorten'} the sound by ${seconds(size(minus(length, exactly(limit))))} or more`,
    severity: length_locked ? ('error' as const) : ('warning' as const),
    measured: toNumber(length),
    limit,
    unit: 's',
  }
}

function* againstRequest(length: Fraction, askedS: number, { length_locked, frame_rate_fps }: CueLength) {
  const asked = exactly(askedS)
  const off = minus(length, asked)
  const turn = off.over > 0n ? 'shorten' : 'lengthen'
  const of = { measured: toNumber(length), limit: askedS, unit: 's' }
  if (length_locked) {
    const fps = frame_rate_fps ?? USUAL_FPS
    const { over, under } = exactly(fps)
    if (!isMore(size(off), { over: under, under: over })) return
    yield {
      ...of,
      code: 'duration:locked',
      message: `${seconds(length)} long; locked to ${general(askedS)} s within one frame of ${general(fps)} fps`,
      fix: `${turn} the sound by ${seconds(size(off))}`,
      severity: 'error' as const,
    }
  } else if (isMore(size(off), { over: asked.over, under: asked.under * 4n })) {
    yield {
      ...of,
      code: 'duration:cue',
      message: `${seconds(length)} long; the sound list asks for about ${general(askedS)} s`,
      fix: `${turn} the sound, or say on the cue why it needs this length`,
      severity: 'warning' as const,
    }
  }
}

function loweringAdvice(excessDb: number, isCutOff: boolean): string {
  const lower = `lower the level by ${fixed(excessDb, 2)} dB`
  if (!isCutOff) return `${lower} or more`
  return (
    'its tops are cut off flat, and a lower level leaves them so: lower the gain before the stage that clips, and ' +
    `export again; only if the flat tops are meant, ${lower}`
  )
}

function* samplePeak({ layout, peaks, spec }: Subject): Iterable<Found> {
  const { sample_peak_dbfs: limit, tolerance_db: tolerance } = spec.limits
  if (limit === null) return
  const peak = peakOf(peaks)
  if (peak <= limit + tolerance) return
  const atS = peaks.frame / layout.sampleRateHz
  yield {
    code: 'sample-peak:over',
    message: `sample peak ${fixed(peak, 2)} dBFS, limit ${levelShown(limit)} dBFS`,
    fix: loweringAdvice(peak - limit, peaks.isCutOff),
    measured: peak,
    limit,
    unit: 'dBFS',
    start_s: atS,
    end_s: atS,
  }
}

function* silence({ layout, peaks, spec }: Subject): Iterable<Found> {
  const { silence_below_dbfs: limit, tolerance_db: tolerance } = spec.limits
  if (limit === null) return
  const peak = peakOf(peaks)
  const where = { start_s: 0, end_s: durationOf(layout) }
  if (peak < limit - tolerance) {
    const level = peak === -Infinity ? 'digital silence' : `peak only ${fixed(peak, 1)} dBFS`
    yield {
      ...where,
      code: 'silence:file',
      message: `${level}, silent below ${levelShown(limit)} dBFS`,
      fix: 'unmute the track or choose the right range, and export again',
      measured: peak === -Infinity ? null : peak,
      limit,
      unit: 'dBFS',
    }
    return
  }
  const dead = [...peaks.channels].flatMap((level, index) => (decibels(level) < limit - tolerance ? [index + 1] : []))
  if (dead.length === 0) return
  yield {
    ...where,
    code: 'silence:channel',
    message: `no sound in channel ${dead.join(', ')} of ${layout.channels}`,
    fix: 'export the sound in mono, or bring the missing channel back',
    severity: 'warning',
  }
}

/** In the order of reports. */
const CHECKS: Record<string, (subject: Subject) => Iterable<Found>> = {
  container,
  encoding,
  'sample-rate': sampleRate,
  'bit-depth': bitDepth,
  channels,
  duration,
  'sample-peak': samplePeak,
  silence,
}
export const CHECKED_HERE: readonly string[] = Object.keys(CHECKS)

export const whole = (partial: Found): Finding => ({
  severity: 'error',
  measured: null,
  limit: null,
  unit: null,
  start_s: null,
  end_s: null,
  auto_fix: null,
  ...partial,
})

/** What the checks find, errors first. */
export function check(subject: Subject): Finding[] {
  const findings = Object.entries(CHECKS).flatMap(([name, run]) => {
    const level = subject.spec.levels[name]
    if (level === 'off') return []
    return [...run(subject)]
      .map((partial) => whole(level === undefined ? partial : { ...partial, severity: level }))
      .map((finding) => ({ ...finding, auto_fix: autoFix(finding, subject) }))
  })
  return findings.toSorted((a, b) => Number(b.severity === 'error') - Number(a.severity === 'error'))
}
