/** Numbers as the server writes them: the same digits, in the same sentences. */

/** With so many decimals. A number half-way between two goes to the even one; what rounds to zero has no sign. */
export function fixed(value: number, decimals: number): string {
  const rounded = Math.abs(value).toFixed(decimals)
  const exact = Math.abs(value).toFixed(Math.min(100, decimals + 60))
  const at = exact.indexOf('.') + 1 + decimals
  const isHalf = /^50*$/.test(exact.slice(at))
  const down = decimals === 0 ? exact.slice(0, at - 1) : exact.slice(0, at)
  const text = isHalf && Number(down.at(-1)) % 2 === 0 ? down : rounded
  return value < 0 && Number(text) !== 0 ? `-${text}` : text
}

/** With six digits at most, and none that say nothing: 44100, 0.5, 1e-05. */
export function general(value: number): string {
  if (value === 0) return '0'
  const [digits = '', power = '0'] = value.toExponential(5).split('e')
  const exponent = Number(power)
  if (exponent >= -4 && exponent < 6) return String(Number(value.toPrecision(6)))
  const sign = exponent < 0 ? '-' : '+'
  return `${Number(digits)}e${sign}${String(Math.abs(exponent)).padStart(2, '0')}`
}

/** A level of the spec with one decimal at least. */
export function levelShown(level: number): string {
  const text = general(level)
  return /[.e]/.test(text) ? text : `${text}.0`
}

/** A fraction of whole numbers: lengths are compared exactly. */
export interface Fraction {
  over: bigint
  under: bigint
}

/** The number as it was written: 0.1 is a tenth. */
export function exactly(value: number): Fraction {
  const [digits = '', power = '0'] = String(value).split('e')
  const [whole = '', decimals = ''] = digits.split('.')
  const shift = Number(power) - decimals.length
  const over = BigInt(whole + decimals)
  return shift >= 0 ? { over: over * 10n ** BigInt(shift), under: 1n } : { over, under: 10n ** BigInt(-shift) }
}

export const minus = (a: Fraction, b: Fraction): Fraction => ({
  over: a.over * b.under - b.over * a.under,
  under: a.under * b.under,
})

export const isMore = (a: Fraction, b: Fraction): boolean => minus(a, b).over > 0n

export const size = ({ over, under }: Fraction): Fraction => ({ over: over < 0n ? -over : over, under })

export const toNumber = ({ over, under }: Fraction): number => {
  const whole = over / under
  return Number(whole) + Number(over - whole * under) / Number(under)
}
