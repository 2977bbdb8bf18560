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
  const judgement = judgements[name]
  if (!isTable(judgement) || typeof judgement.verdict !== 'string' || !isTable(judgement.evidence)) return null
  return {
    verdict: judgement.verdict,
    score: numberOf(judgement.score),
    figures: judgement,
    evidence: judgement.evidence,
  }
}
