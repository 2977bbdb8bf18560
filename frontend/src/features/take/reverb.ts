import { isTable, numberOf } from './judged'

type Values = Record<string, unknown>

/** How one octave dies away after it was last loud. */
export interface DecayBand {
  hz: number
  rt60S: number | null
  rateDbS: number | null
  /** 0 at the start, one point each step. */
  curveDb: readonly number[]
  /** How alike left and right are in head and tail, 0–1; null in mono and where there is no such part. */
  head: number | null
  tail: number | null
}

/** What the judgement of reverb goes by, and what it says. */
export interface ReverbEvidence {
  verdict: string
  score: number | null
  rt60S: number | null
  stepS: number
  bands: readonly DecayBand[]
  isStereo: boolean
  stem: ReverbStem | null
  before: ReverbBefore | null
}

/** The result of the comparison with its dry stem. */
export interface ReverbStem {
  verdict: string
  /** Of what was added. */
  rt60S: number | null
  wetDb: number | null
  /** Why nothing can be said. */
  why: string
}

function stemOf(value: unknown): ReverbStem | null {
  if (!isTable(value) || typeof value.verdict !== 'string') return null
  const why = typeof value.why === 'string' ? value.why : ''
  return { verdict: value.verdict, rt60S: numberOf(value.rt60_s), wetDb: numberOf(value.wet_db), why }
}

/** Its reverb compared with the designer's previous version. */
export interface ReverbBefore {
  takeId: string
  number: number
  verdict: string
  /** Of what was added, or taken away. */
  rt60S: number | null
  wetDb: number | null
  bands: readonly { hz: number; rt60S: number | null; earlierRt60S: number | null }[]
}

function beforeOf(value: unknown): ReverbBefore | null {
  if (!isTable(value) || typeof value.take_id !== 'string' || typeof value.verdict !== 'string') return null
  const bands = isTable(value.evidence) && Array.isArray(value.evidence.bands) ? value.evidence.bands : []
  return {
    takeId: value.take_id,
    number: Number(value.number),
    verdict: value.verdict,
    rt60S: numberOf(value.rt60_s),
    wetDb: numberOf(value.wet_db),
    bands: bands.filter(isTable).map((band) => ({
      hz: Number(band.hz),
      rt60S: numberOf(band.rt60_s),
      earlierRt60S: numberOf(band.earlier_rt60_s),
    })),
  }
}

/** The evidence as a check's report holds it; null where nothing was judged or nothing dies away. */
export function reverbOf(judgements: Values): ReverbEvidence | null {
  const { reverb } = judgements
  if (!isTable(reverb) || !isTable(reverb.evidence) || !isTable(reverb.evidence.decay)) return null
  const { decay, coherence } = reverb.evidence
  const sides = Array.isArray(coherence) ? coherence.filter(isTable) : []
  const bands = (Array.isArray(decay.bands) ? decay.bands : []).filter(isTable).map((band): DecayBand => {
    const side = sides.find(({ hz }) => hz === band.hz)
    return {
      hz: Number(band.hz),
      rt60S: numberOf(band.rt60_s),
      rateDbS: numberOf(band.rate_db_s),
      curveDb: Array.isArray(band.curve_db) ? band.curve_db.filter((db) => typeof db === 'number') : [],
      head: numberOf(side?.head),
      tail: numberOf(side?.tail),
    }
  })
  if (bands.length === 0 || typeof reverb.verdict !== 'string') return null
  return {
    verdict: reverb.verdict,
    score: numberOf(reverb.score),
    rt60S: numberOf(reverb.rt60_s),
    stepS: numberOf(decay.step_s) ?? 0,
    bands,
    isStereo: sides.length > 0,
    stem: stemOf(reverb.stem),
    before: beforeOf(reverb.before),
  }
}
