import type { components } from '@/api/schema.gen'
import { plural } from '@/ui/format'

type Schemas = components['schemas']
export type Phase = Schemas['Phase']
type PhaseRead = Schemas['PhaseRead']
type Awaited = Schemas['PhaseAwaited']

export const PHASES = [
  { value: 'concept', label: 'Concept' },
  { value: 'palette', label: 'Palette' },
  { value: 'alpha', label: 'Alpha' },
  { value: 'beta', label: 'Beta' },
  { value: 'gold', label: 'Gold' },
] as const satisfies readonly { value: Phase; label: string }[]

export const PHASE_WORDS: Record<string, string> = Object.fromEntries(PHASES.map(({ value, label }) => [value, label]))

const ACTS: Record<Awaited['act'], (count: number) => string> = {
  deliver: (count) => `to deliver ${count}`,
  review: (count) => `to review ${count}`,
  answer: (count) => `to answer on ${count}`,
  approve_palette: () => 'to approve the palette as a set',
}

/** What is missing for a phase to be done, and who must act: "3 cues without an accepted version: Ida to deliver 2". */
export function gateWords({ cues, accepted, awaited }: PhaseRead): string {
  const missing = cues - accepted
  const acts = awaited.map(({ who, act, count }) => `${who ?? 'a designer'} ${ACTS[act](count)}`)
  const summary = missing > 0 ? `${plural(missing, 'cue')} without an accepted version` : 'Every sound is accepted'
  return acts.length > 0 ? `${summary}: ${acts.join(', ')}.` : `${summary}.`
}
