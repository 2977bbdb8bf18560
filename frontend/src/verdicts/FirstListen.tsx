import { useHotkeys } from '@/app/keys'
import { ENOUGH_S } from '@/heard/heardMeter'
import { Key } from '@/ui/Key'
import { plural } from '@/ui/format'

import type { ReviewTake } from './api'
import { soundOf } from './hearing'
import type { FirstListen as Listening } from './useFirstListen'

interface FirstListenProps {
  listen: Listening
  /** How many versions are approved at once. */
  count: number
  target: string
  nameOf: (take: ReviewTake) => string
  /** What the button that approves says. */
  button?: string
  /** Why there is nothing to hear; null where there is. */
  silent: string | null
  /** The way around it; left out where a menu has it. */
  onApproveUnheard?: () => void
}

/** What an approval waits for, as long as a version was not heard; the way around it is named, and recorded. */
export function FirstListen({
  listen,
  count,
  target,
  nameOf,
  button = 'Approve',
  silent,
  onApproveUnheard,
}: FirstListenProps) {
  const { unheard, listening, isOver, stop } = listen
  useHotkeys([
    { keys: 'Escape', label: 'Stop', group: 'Review', unlisted: true, run: stop, disabled: listening === null },
  ])
  if (unheard.length === 0) {
    return (
      <span aria-live="polite">
        {isOver && (
          <>
            Heard. Press {button} <Key keys="a" /> again.
          </>
        )}
      </span>
    )
  }
  return (
    <span>
      <span aria-live="polite">
        {listening ? (
          <>
            {onApproveUnheard && (
              <>
                <span className="strong">{nameOf(listening)} is playing for the first time.</span> Not approved
                yet.{' '}
              </>
            )}
            Press {button} <Key keys="a" /> again once {enoughWords(unheard, target)} played.
          </>
        ) : (
          <>
            {notHeardWords(unheard, count, nameOf)}{' '}
            {silent ?? (
              <>
                {button} <Key keys="a" /> plays {unheard.length === 1 ? 'it' : 'them'} first.
              </>
            )}
          </>
        )}
      </span>{' '}
      {listening && onApproveUnheard && (
        <>
          <button type="button" className="link" onClick={stop}>
            Stop <Key keys="Escape" />
          </button>{' '}
        </>
      )}
      {onApproveUnheard && (
        <button type="button" className="link" onClick={onApproveUnheard}>
          Approve without listening
        </button>
      )}
    </span>
  )
}

function notHeardWords(unheard: readonly ReviewTake[], count: number, nameOf: (take: ReviewTake) => string): string {
  const [first] = unheard
  if (first && count === 1) return `You have not heard ${nameOf(first)} yet.`
  if (unheard.length === count) return `You have not heard the ${plural(count, 'file')} yet.`
  return `You have not heard ${unheard.length} of the ${plural(count, 'file')} yet.`
}

/** "it has", "30 s of it have", "the 3 files have". */
function enoughWords(unheard: readonly ReviewTake[], target: string): string {
  const [first] = unheard
  if (unheard.length > 1) return `the ${plural(unheard.length, 'file')} have`
  return first && soundOf(first, target).durationS > ENOUGH_S ? `${ENOUGH_S} s of it have` : 'it has'
}
