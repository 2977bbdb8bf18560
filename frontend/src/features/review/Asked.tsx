import type { ChangeRequest } from '@/verdicts/api'
import { spot } from '@/verdicts/words'
import { WordText } from '@/references'
import { Button } from '@/ui/Button'
import { Key } from '@/ui/Key'

import classes from './Review.module.css'

interface AskedProps {
  projectId: string
  asked: readonly ChangeRequest[]
  /** The version that it was asked of. */
  number: number
  /** Whether that version is the one in hand. */
  isHeard: boolean
  onFlip: () => void
  onSpot: (startS: number) => void
}

/** What was asked of the version before, beside the one that answers it. */
export function Asked({ projectId, asked, number, isHeard, onFlip, onSpot }: AskedProps) {
  return (
    <section
      className={`flex items-start gap-2-4 wrap-anywhere ${classes.asked}`}
      aria-label={`What was asked of version ${number}`}
    >
      <ul className="grow">
        {asked.map(({ id, text, start_s: startS, end_s: endS, written_by: by }) => (
          <li key={id}>
            <span className="small mid">{by.name} asked: </span>
            <span className="lead">
              “<WordText projectId={projectId} text={text} />”
            </span>{' '}
            {startS !== null && (
              <button type="button" className="link mono small mid nowrap" onClick={() => onSpot(startS)}>
                {spot(startS, endS)}
              </button>
            )}
          </li>
        ))}
      </ul>
      <Button variant="quiet" icon="ab" onClick={onFlip}>
        {isHeard ? 'Back to the new version' : `Hear version ${number}`} <Key keys="b" />
      </Button>
    </section>
  )
}
