import type { CueMoney } from './api'

/** Sums as people read them: "$7,200.00", a true minus, as many decimals as the currency has. */

function formatOf(currency: string, style: 'currency' | 'decimal'): { text: Intl.NumberFormat; digits: number } {
  const digits =
    new Intl.NumberFormat('en-US', { style: 'currency', currency }).resolvedOptions().maximumFractionDigits ?? 2
  const decimals = { minimumFractionDigits: digits, maximumFractionDigits: digits }
  return { text: new Intl.NumberFormat('en-US', { style, currency, ...decimals }), digits }
}

function written(amountMinor: number, currency: string, style: 'currency' | 'decimal'): string {
  const { text, digits } = formatOf(currency, style)
  return text.format(amountMinor / 10 ** digits).replace('-', '−')
}

/** "$697.50". */
export const money = (amountMinor: number, currency: string): string => written(amountMinor, currency, 'currency')

/** "697.50", where the currency is shown next to it. */
export const amount = (amountMinor: number, currency: string): string => written(amountMinor, currency, 'decimal')

/** A typed amount in whole minor units; null if it is none. */
export function minorOf(typed: string, currency: string): number | null {
  const { digits } = formatOf(currency, 'decimal')
  const found = /^([−-]?)(\d{1,10})(?:\.(\d+))?$/.exec(typed.replaceAll(/[,\s]/g, ''))
  if (!found || (found[3] ?? '').length > digits) return null
  const minor = Number(found[2]) * 10 ** digits + Number((found[3] ?? '').padEnd(digits, '0') || '0')
  return found[1] ? -minor : minor
}

/** "50 %", "12.5 %". */
export const percent = (basisPoints: number): string => `${Number((basisPoints / 100).toFixed(2))} %`

/** "$180.00 is due then, and Alpha is 4 of 10."; empty where accepting the cue changes nothing. */
export function dueWithPick({
  accepted,
  accepted_then,
  wanted,
  milestone,
  would_owe_minor,
  currency,
}: CueMoney): string {
  if (accepted_then === accepted && would_owe_minor === 0) return ''
  const stands = `${milestone} is ${accepted_then} of ${wanted}`
  return would_owe_minor > 0 ? `${money(would_owe_minor, currency)} is due then, and ${stands}.` : `${stands} then.`
}

/** "4 days late: 1 with the designer, 3 with you." */
export function slipInWords(
  { days, designer_days: designer, studio_days: studio }: { days: number; designer_days: number; studio_days: number },
  side: 'team' | 'designer',
): string {
  if (days === 0) return 'on time'
  const late = `${days} ${days === 1 ? 'day' : 'days'} late`
  const [you, they] = side === 'team' ? [studio, designer] : [designer, studio]
  const whose = side === 'team' ? 'the designer' : 'the studio'
  const parts = [they > 0 ? `${they} with ${whose}` : '', you > 0 ? `${you} with you` : ''].filter(Boolean)
  return `${late}: ${parts.join(', ')}`
}
