import { Button } from './Button'
import { Icon } from './Icon'

export interface SaveStatusProps {
  state: 'saving' | 'saved' | 'failed'
  /** When it was saved, as it is shown: "21:04". */
  at?: string
  /** Why it was not saved; what was typed is kept. */
  why?: string
  onRetry?: () => void
}

/** Says of a text that saves itself where it stands. */
export function SaveStatus({ state, at, why, onRetry }: SaveStatusProps) {
  return (
    <span role="status" className={state === 'failed' ? 'row small tone-bad toned' : 'row small mid'}>
      {state === 'saving' && (
        <>
          <span className="ring" aria-hidden="true" />
          Saving…
        </>
      )}
      {state === 'saved' && (
        <>
          <Icon name="tick" />
          {at === undefined ? 'Saved' : `Saved, ${at}`}
        </>
      )}
      {state === 'failed' && (
        <>
          <Icon name="back" />
          {why === undefined ? 'Not saved' : `Not saved: ${why}`}
          {onRetry && <Button onClick={onRetry}>Try again</Button>}
        </>
      )}
    </span>
  )
}
