import classes from './Meter.module.css'
import type { Tone } from './StatusBadge'

export interface MeterPart {
  value: number
  /** Without one it is ink. */
  tone?: Tone
}

interface MeterProps {
  /** What it says, in words: "3 of 10 accepted, 4 to review". */
  label: string
  whole: number
  parts: readonly MeterPart[]
  thin?: boolean
}

/** A bar of parts of a whole; the text next to it says the same. */
export function Meter({ label, whole, parts, thin = false }: MeterProps) {
  return (
    <span role="img" aria-label={label} className={thin ? `${classes.meter} ${classes.thin}` : classes.meter}>
      {parts
        .filter(({ value }) => value > 0)
        .map(({ value, tone }, index) => (
          <i
            key={index}
            className={tone ? `tone-${tone} ${classes.toned}` : undefined}
            style={{ width: `${whole > 0 ? Math.min(100, (value / whole) * 100) : 0}%` }}
          />
        ))}
    </span>
  )
}
