/** The effect of a broken rule of the spec: the take is returned, a warning is shown, or nothing happens. */
export type Severity = 'error' | 'warning' | 'off'

export interface CheckName {
  name: string
  word: string
  /** What holds when the spec says nothing. */
  usual: Severity
  /** Found over files together: no take comes back for it. */
  overFiles?: boolean
}

/** The checks of a file's form, which no limit names. */
export const FORM_CHECKS: readonly CheckName[] = [
  { name: 'container', word: 'Container', usual: 'error' },
  { name: 'encoding', word: 'Encoding', usual: 'error' },
  { name: 'sample-rate', word: 'Sample rate', usual: 'error' },
  { name: 'bit-depth', word: 'Bit depth', usual: 'error' },
  { name: 'channels', word: 'Channels', usual: 'error' },
  { name: 'duration', word: 'Length', usual: 'error' },
  { name: 'naming', word: 'Name', usual: 'error' },
  { name: 'clipping', word: 'Clipping', usual: 'warning' },
  { name: 'placeholder', word: 'Placeholder', usual: 'warning' },
]

/** The checks that look for faults in the sound itself, and over files together; a category changes them in its TOML. */
export const FAULT_CHECKS: readonly CheckName[] = [
  { name: 'click', word: 'Clicks', usual: 'warning' },
  { name: 'dropout', word: 'Dropouts', usual: 'warning' },
  { name: 'cut-start', word: 'Abrupt start', usual: 'warning' },
  { name: 'cut-tail', word: 'Abrupt end', usual: 'warning' },
  { name: 'hum', word: 'Hum', usual: 'warning' },
  { name: 'loop-points', word: 'Loop points', usual: 'warning' },
  { name: 'false-stereo', word: 'Dual mono', usual: 'warning' },
  { name: 'padded-bits', word: 'Zero-padded bits', usual: 'warning' },
  { name: 'metadata', word: 'Metadata', usual: 'warning' },
  { name: 'duplicate', word: 'Duplicate audio', usual: 'warning', overFiles: true },
  { name: 'variation-set', word: 'Inconsistent variation', usual: 'warning', overFiles: true },
  { name: 'reverb-set', word: 'Reverb across a set', usual: 'warning', overFiles: true },
]

export interface LimitName {
  key: string
  word: string
  unit: string
  /** The check that keeps it; without one the limit only tunes others. */
  check?: string
  /** What follows when the spec says nothing; the take comes back, unless it says otherwise. */
  severity?: Severity
  hint?: string
  /** What holds when the spec says nothing. */
  usual?: number
}

export const LIMITS: readonly LimitName[] = [
  { key: 'sample_peak_dbfs', word: 'Sample peak', unit: 'dBFS', check: 'sample-peak' },
  { key: 'true_peak_dbtp', word: 'True peak', unit: 'dBTP', check: 'true-peak' },
  { key: 'dc_offset_percent', word: 'DC offset', unit: '%', check: 'dc-offset' },
  { key: 'silence_below_dbfs', word: 'Counts as silence below', unit: 'dBFS', check: 'silence' },
  { key: 'head_silence_ms', word: 'Leading silence', unit: 'ms', check: 'head-silence' },
  { key: 'tail_silence_ms', word: 'Trailing silence', unit: 'ms', check: 'tail-silence' },
  { key: 'mono_loss_db', word: 'Mono fold-down loss', unit: 'dB', check: 'phase', severity: 'warning' },
]

export const TUNING: readonly LimitName[] = [
  {
    key: 'edge_silence_below_dbfs',
    word: 'Trim threshold',
    unit: 'dBFS',
    usual: -60,
  },
  { key: 'tolerance_db', word: 'Tolerance on levels', unit: 'dB', usual: 0.05 },
]

/** How severe a check is by what the tables say. */
export function severityOf(checks: Record<string, unknown>, name: string, usual: Severity = 'error'): Severity {
  const said = checks[name]
  return said === 'error' || said === 'warning' || said === 'off' ? said : usual
}
