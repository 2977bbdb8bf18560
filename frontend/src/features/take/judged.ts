type Values = Record<string, unknown>

export const isTable = (value: unknown): value is Values =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
export const numberOf = (value: unknown): number | null => (typeof value === 'number' ? value : null)

/** A judgement of the report that has evidence to be shown; null where nothing was judged. */
export interface Judged {
  verdict: string
  score: number | null
  figures: Values
  evidence: Values
}

export function judgedOf(judgements: Values, name: string): Judged | null {
  const found = judgements[name]
  if (!isTable(found) || typeof found.verdict !== 'string' || !isTable(found.evidence)) return null
  return { verdict: found.verdict, score: numberOf(found.score), figures: found, evidence: found.evidence }
}
