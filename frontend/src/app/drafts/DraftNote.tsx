import type { Draft } from './useDraft'

/** Says that a form shows what was typed before, with a way back to what it began with. */
export function DraftNote({ draft }: { draft: Pick<Draft, 'isRestored' | 'discard'> }) {
  if (!draft.isRestored) return null
  return (
    <p className="small mid" role="status">
      Draft restored ·{' '}
      <button type="button" className="link" onClick={draft.discard}>
        Discard
      </button>
    </p>
  )
}
