import type { ImportAsk, ImportField } from './api'

/** A sheet on its way into the list, with how it is to be read. */
export interface SheetDraft {
  /** What was pasted or typed. */
  text: string
  file: { name: string; format: 'csv' | 'xlsx'; contentBase64: string } | null
  /** What the person chose; every other column is read as guessed. */
  mapping: Record<string, ImportField>
  match: NonNullable<ImportAsk['match']>
}

export const EMPTY_SHEET: SheetDraft = { text: '', file: null, mapping: {}, match: 'number' }

const kept = new Map<string, SheetDraft>()

/** A sheet survives leaving the page, until it is imported. */
export const keptSheet = (projectId: string): SheetDraft => kept.get(projectId) ?? EMPTY_SHEET

export function keepSheet(projectId: string, sheet: SheetDraft | null): void {
  if (sheet === null) kept.delete(projectId)
  else kept.set(projectId, sheet)
}
