import { Link } from '@tanstack/react-router'

import { ButtonLink } from '@/ui/Button'
import { day, plural } from '@/ui/format'

import type { Contract } from './api'
import classes from './Contracts.module.css'

/** That changes were proposed clause by clause, how many wait for an answer, and where to read them. */
export function RedlinesNote({ contract, to }: { contract: Contract; to: string }) {
  const { redlines } = contract
  if (!redlines) return null
  const { count, unanswered, by, at } = redlines
  const proposed = `${by} proposed ${plural(count, 'change')}, ${day(at)}.`
  return (
    <div className={redlines.is_open ? `m-0 p-3-4 ${classes.asked} ${classes.redlines}` : classes.redlines}>
      <p>
        {!redlines.is_open
          ? `${proposed} The studio answered with this version.`
          : unanswered === 0
            ? `${proposed} All are answered; the next version is not sent yet.`
            : `${proposed} ${unanswered === count ? 'None is answered yet.' : `${unanswered} without an answer.`}`}
      </p>
      <ButtonLink component={Link} to={to}>
        Redlines
      </ButtonLink>
    </div>
  )
}
