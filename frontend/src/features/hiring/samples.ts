import type { components } from '@/api/schema.gen'

import type { ComparedBid } from './api'

export type Sample = components['schemas']['SampleRead']

export const MAX_SAMPLE_BYTES = 6_000_000

/** What the check said of a sample, in words, and its tone. */
export function verdictOf({ state, findings, problem, spec_version: version }: Sample): {
  words: string
  tone: string
} {
  if (state === 'pending') return { words: 'being checked', tone: '' }
  if (state === 'unchecked') return { words: `not checked: ${problem}`, tone: 'warn' }
  const by = version === null ? '' : `, by version ${version} of the spec`
  if (state === 'returned') {
    const first = findings.find(({ severity }) => severity === 'error') ?? findings[0]
    return { words: `does not conform${first ? `: ${first.message}` : ''}${by}`, tone: 'bad' }
  }
  return { words: `conforms${by}`, tone: 'ok' }
}

/** The sample of the next bid that is for the same line, at the same place among those of the line where it has one. */
export function matchingSampleOfNextBid(
  bids: readonly ComparedBid[],
  playingId: string | null,
): { bid: ComparedBid; id: string } | null {
  const open = bids.map((bid) => ({ bid, samples: bid.samples.filter((sample) => sample.is_open) }))
  const at = open.findIndex(({ samples }) => samples.some(({ id }) => id === playingId))
  const playing = open[at]?.samples.find(({ id }) => id === playingId)
  if (playing === undefined) {
    const first = open.find(({ samples }) => samples.length > 0)
    return first?.samples[0] ? { bid: first.bid, id: first.samples[0].id } : null
  }
  const ofLine = (samples: readonly Sample[]) => samples.filter(({ line_key: key }) => key === playing.line_key)
  const place = ofLine(open[at]?.samples ?? []).findIndex(({ id }) => id === playing.id)
  for (let step = 1; step < open.length; step += 1) {
    const next = open[(at + step) % open.length]
    const same = next && ofLine(next.samples)
    const sample = same?.[place] ?? same?.[0]
    if (next && sample) return { bid: next.bid, id: sample.id }
  }
  return null
}

/** A file as a request carries it. */
export function base64Of(file: File): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader()
    reader.onload = () => resolve((reader.result as string).split(',')[1] ?? '')
    reader.onerror = () => reject(reader.error ?? new Error('the file could not be read'))
    reader.readAsDataURL(file)
  })
}
