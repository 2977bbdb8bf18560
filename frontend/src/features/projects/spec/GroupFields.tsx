import { rate } from '@/ui/format'

import { checksWithoutLimit, type HeldLimit, statedLimits, useChecks } from './checks'
import { Against, Choices, NumberField, SeverityField } from './fields'
import classes from './SpecForm.module.css'

const RATES = [44100, 48000, 88200, 96000, 192000].map((value) => ({ value, label: rate(value) }))
const DEPTHS = [16, 24, 32].map((value) => ({ value, label: `${value} bit` }))
const CHANNELS = [
  { value: 1, label: 'mono' },
  { value: 2, label: 'stereo' },
]
const CONTAINERS = [
  { value: 'wav', label: 'WAV' },
  { value: 'rf64', label: 'RF64' },
  { value: 'flac', label: 'FLAC' },
]
const ENCODINGS = [
  { value: 'pcm', label: 'PCM' },
  { value: 'float', label: 'float' },
]
/** What a file may be: of the spec at large, or of one category. */
export function AcceptFields({ base }: { base: readonly string[] }) {
  const accept = (key: string) => [...base, 'accept', key]
  return (
    <>
      <Choices place={accept('containers')} label="Container" options={CONTAINERS} />
      <Choices place={accept('encodings')} label="Encoding" options={ENCODINGS} />
      <Choices place={accept('sample_rates_hz')} label="Sample rate" options={RATES} />
      <Choices place={accept('bit_depths')} label="Bit depth" options={DEPTHS} />
      <Choices place={accept('channels')} label="Channels" options={CHANNELS} />
      <div className={`min-w-0 ${classes.field}`}>
        <div className="grid gap-2 grid-cols-1fr-1fr">
          <NumberField place={[...accept('duration_s'), 'min']} label="Minimum length" unit="s" />
          <NumberField place={[...accept('duration_s'), 'max']} label="Maximum length" unit="s" />
        </div>
      </div>
    </>
  )
}

/** The levels and edges of all checks, or of some, each with what follows when it is broken. */
export function LimitFields({ base, of }: { base: readonly string[]; of?: readonly string[] }) {
  const limits = statedLimits(useChecks()).filter(({ check }) => of === undefined || of.includes(check.name))
  return (
    <div className="grid gap-2">
      {limits.map((limit) => (
        <LimitLine key={limit.key} limit={limit} base={base} />
      ))}
    </div>
  )
}

/** What follows from checks that no limit names: all of them, or some. */
export function CheckFields({ of }: { of?: readonly string[] }) {
  const checks = checksWithoutLimit(useChecks()).filter(({ name }) => of === undefined || of.includes(name))
  return (
    <ul className={`grid ${classes.checks}`}>
      {checks.map(({ name, label, why, severity, may_return: returns }) => (
        <li key={name}>
          <span title={why}>{label}</span>
          <SeverityField base={['checks']} check={name} label={label} usual={severity} returns={returns} />
          <Against place={['checks', name]} />
        </li>
      ))}
    </ul>
  )
}

function LimitLine({
  limit: { key, label, unit, is_range: isRange, check },
  base,
}: {
  limit: HeldLimit
  base: readonly string[]
}) {
  const place = [...base, 'limits', key]
  const word = label.toLowerCase()
  return (
    <div className={`grid items-center gap-1-4 narrow-grid-cols-1 ${classes.limit}`}>
      <span title={check.why}>{label}</span>
      {isRange ? (
        <div className="grid gap-2 grid-cols-1fr-1fr">
          <NumberField place={[...place, 'min']} label={`Minimum ${word}`} unit={unit} hideLabel />
          <NumberField place={[...place, 'max']} label={`Maximum ${word}`} unit={unit} hideLabel />
        </div>
      ) : (
        <NumberField place={place} label={label} unit={unit} hideLabel />
      )}
      <SeverityField
        base={[...base, 'checks']}
        check={check.name}
        label={label}
        usual={check.severity}
        returns={check.may_return}
      />
    </div>
  )
}
