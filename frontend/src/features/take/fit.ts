import type { components } from '@/api/schema.gen'
import { figure, level, score } from '@/ui/format'

type Schemas = components['schemas']
export type TakeFit = Schemas['TakeFitRead']
export type DeliveryFit = Schemas['DeliveryFitRead']
export type MeasureFit = Schemas['MeasureFit']
type Measure = MeasureFit['measure']

export const WHAT: Record<Measure, string> = {
  loudness: 'Loudness',
  spectrum: 'Spectrum, distance from median',
  dryness: 'Reverb, 0 (dry) to 1',
  timbre: 'Timbre, distance from median',
}

/** A figure of one measure with its unit. */
export function said(measure: Measure, value: number): string {
  if (measure === 'loudness') return level(value, 'LUFS')
  return measure === 'dryness' ? score(value) : `${figure(value, 1)} dB`
}

/** How much one lies over another, with its sign. */
export function moved(measure: Measure, by: number): string {
  const unit = { loudness: ' LU', spectrum: ' dB', dryness: '', timbre: ' dB' }[measure]
  return `${by < 0 ? '' : '+'}${figure(by, measure === 'dryness' ? 2 : 1)}${unit}`
}

const STANDS: Record<Measure, Record<MeasureFit['stands'], string>> = {
  loudness: { within: 'within their range', above: 'louder than all', below: 'quieter than all' },
  spectrum: { within: 'within their range', above: 'different spectrum', below: 'within their range' },
  dryness: { within: 'within their range', above: 'more reverberant', below: 'drier than all' },
  timbre: { within: 'within their range', above: 'different timbre', below: 'within their range' },
}

export const stands = ({ measure, stands: where }: MeasureFit): string => STANDS[measure][where]

/** The least that an axis spans, so that sounds that are alike lie together. */
const SPAN: Record<Measure, number> = { loudness: 12, spectrum: 12, dryness: 1, timbre: 8 }

/** From and to of the axis on which a sound and the others lie. */
export function axisOf({ measure, value, others }: MeasureFit): [from: number, to: number] {
  if (measure === 'dryness') return [0, 1]
  const all = [value, ...others.map((other) => other.value)]
  const [low, high] = measure === 'loudness' ? [Math.min(...all), Math.max(...all)] : [0, Math.max(...all)]
  const spare = Math.max(0, SPAN[measure] - (high - low))
  return measure === 'loudness' ? [low - spare / 2, high + spare / 2] : [low, high + spare]
}
