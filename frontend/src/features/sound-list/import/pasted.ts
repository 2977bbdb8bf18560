import { keepDraft, keptDraft } from '@/app/drafts'

import type { ImportAsk, ImportField } from './api'

/** A sheet on its way into the list, with how it is to be read. */
export interface SheetDraft {
  /** What was pasted or typed. */
  text: string
  file: { name: string; format: 'csv' | 'xlsx'; contentBase64: string } | null
  /** What the person chose; every other column is read as guessed. */
  mapping: Record<string, ImportField>
  match: NonNullable<ImportAsk['match']>
  /** What the person changed of how the sheet is read; the rest is as the server guesses. */
  read: SheetReading
}

export type SheetReading = Pick<
  Partial<ImportAsk>,
  | 'tab'
  | 'encoding'
  | 'fill_down'
  | 'fill_down_columns'
  | 'edits'
  | 'keep_hidden'
  | 'skip_rows'
  | 'keep_rows'
  | 'frame_rate_fps'
  | 'sample_rate_hz'
  | 'day_first'
  | 'use_proposed_names'
>

export const EMPTY_SHEET: SheetDraft = { text: '', file: null, mapping: {}, match: 'number', read: {} }

const keyOf = (projectId: string) => `import:${projectId}`

/** A sheet survives leaving the page, until it is imported. */
export const keptSheet = (projectId: string): SheetDraft | null => {
  const kept = keptDraft<SheetDraft>(keyOf(projectId))
  return kept && { ...EMPTY_SHEET, ...kept }
}

/** Keep it; the answer is whether it outlives a reload, which a large file does not. */
export const keepSheet = (projectId: string, sheet: SheetDraft | null, handedOver = false): boolean =>
  keepDraft(keyOf(projectId), sheet, handedOver)

/** What was chosen for columns that the text still has; columns without a head are named by their place. */
export function mappingFor(text: string, { mapping }: SheetDraft, hasHead: boolean): SheetDraft['mapping'] {
  return Object.fromEntries(Object.entries(mapping).filter(([name]) => !hasHead || text.includes(name)))
}
