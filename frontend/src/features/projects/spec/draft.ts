import * as drafts from '@/app/drafts'

import type { Spec } from '../api'
import { same, type Tables } from './tables'

/** A spec while it is being written, by form or as text. */
export interface SpecDraft {
  basedOn: number
  mode: 'form' | 'toml'
  toml: string
  tables: Tables
  /** The text that the form began from, which keeps its comments as long as the form says the same. */
  from: { toml: string; tables: Tables }
  note: string
}

export const draftOf = ({ version, toml, tables }: Spec, mode: SpecDraft['mode'] = 'form'): SpecDraft => ({
  basedOn: version,
  mode,
  toml,
  tables,
  from: { toml, tables },
  note: '',
})

/** Whether a draft says anything else than the spec that holds. */
export const differs = (draft: SpecDraft, spec: Spec): boolean =>
  draft.mode === 'toml'
    ? draft.toml !== spec.toml
    : draft.from.toml !== spec.toml || !same(draft.tables, draft.from.tables)

/** What a draft sends: the form its tables, unless they say no more than a text that is there. */
export const written = ({ mode, toml, tables, from }: SpecDraft): { toml: string } | { tables: Tables } =>
  mode === 'toml' ? { toml } : same(tables, from.tables) ? { toml: from.toml } : { tables }

const keyOf = (projectId: string) => `spec:${projectId}`

const isDraft = (value: unknown): value is SpecDraft =>
  typeof value === 'object' && value !== null && 'basedOn' in value && 'from' in value && 'toml' in value

/** What was typed and not saved. */
export function keptDraft(projectId: string): SpecDraft | null {
  const kept = drafts.keptDraft(keyOf(projectId))
  return isDraft(kept) ? kept : null
}

/** Keep what is written; another version taken up elsewhere is handed over to the editor. */
export function keepDraft(projectId: string, draft: SpecDraft | null, handedOver = false): void {
  drafts.keepDraft(keyOf(projectId), draft, handedOver)
}
