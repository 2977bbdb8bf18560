import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { ApiProblem } from '@/api'
import type { FindingMark, Player } from '@/audio'
import { ended } from '@/judging/findings'
import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { ProblemNote } from '@/ui/ProblemNote'

import type { Mend } from './api'
import classes from './Mend.module.css'
import { MendWaves } from './MendWaves'
import type { MendedTake, Mending } from './useMending'
import { movedFigures, whatFollows } from './words'

interface MendPanelProps {
  take: MendedTake
  durationS: number | null
  peaksUrl: string | null
  mending: Mending
  player: Player
  findings: readonly FindingMark[]
  limitDbfs?: number
  /** Only the sound's own designer takes a mend; others see that it is offered. */
  mayUse: boolean
  /** What stands where the two waves will, until there are two. */
  children?: ReactNode
  /** Further buttons, after the mend's own. */
  actions?: ReactNode
  /** What stands at the end of the buttons while no mend is there to say it. */
  follows?: ReactNode
}

/** What a mend does about a take: before and mended, to see, to hear and to compare, and the way to take it. */
export function MendPanel(props: MendPanelProps) {
  const { take, durationS, peaksUrl, mending, player, findings, limitDbfs, mayUse, children, actions, follows } = props
  const { mend, sound, error } = mending
  const refusal = error instanceof ApiProblem ? error : null
  const isMade = mend?.state === 'made'
  return (
    <>
      {isMade && sound !== null && durationS !== null ? (
        <MendWaves
          before={{ name: take.name, durationS, peaksUrl }}
          mend={mend}
          sound={sound}
          mending={mending}
          player={player}
          findings={findings}
          limitDbfs={limitDbfs}
        />
      ) : (
        children
      )}
      {mend && isMade && <Moved mend={mend} />}
      {mend && <Standing mend={mend} mayUse={mayUse} />}
      {error !== null && error !== undefined && (
        <ProblemNote
          detail={ended(refusal?.detail ?? 'The page itself broke.')}
          fix={refusal?.fix ? ended(refusal.fix) : undefined}
        />
      )}
      {(mayUse || actions || isMade) && (
        <div className={classes.actions}>
          {mayUse && <Consent mending={mending} />}
          {isMade && sound !== null && (
            <Button icon="ab" keys="b" onClick={mending.flip}>
              {mending.side === 'mended' ? 'Hear before' : 'Hear mended'}
            </Button>
          )}
          {actions}
          <span className={`small mid ${classes.follows}`}>
            {isMade && mayUse ? whatFollows(mend, take.number) : follows}
          </span>
        </div>
      )}
    </>
  )
}

/** The button that says yes: to make the copy first, then to use it. */
function Consent({ mending }: { mending: Mending }) {
  const { mend, isAsking, isUsing } = mending
  if (mend?.state === 'made') {
    return (
      <Button variant="primary" icon="spanner" keys="t" disabled={isUsing} onClick={mending.use}>
        Use the mend
      </Button>
    )
  }
  if (mend?.state === 'offered' || mend?.is_our_fault) {
    return (
      <Button variant="primary" icon="spanner" keys="t" disabled={isAsking} onClick={mending.ask}>
        Mend it
      </Button>
    )
  }
  return null
}

/** How far a mend is, in words. */
function Standing({ mend, mayUse }: { mend: Mend; mayUse: boolean }) {
  switch (mend.state) {
    case 'making':
      return (
        <p className={classes.says} role="status">
          <Icon name="turning" /> The mended copy is being made. The version stays as it is.
        </p>
      )
    case 'offered':
    case 'made':
      return (
        <p className={classes.says}>
          <Icon name="spanner" />
          <span>
            {mend.state === 'offered' ? 'A mend: ' : ''}
            {mend.state === 'offered' ? mend.says.charAt(0).toLowerCase() + mend.says.slice(1) : mend.says}
            {!mayUse && ' Its designer decides whether it becomes a version.'}
          </span>
        </p>
      )
    case 'refused':
      return (
        <p className={classes.says}>
          <Icon name="spanner" />
          <span>{mend.says}</span>
        </p>
      )
    case 'used':
      return (
        <p className={classes.says}>
          <Icon name="tick" />
          <span>
            {mend.new_take_id === null ? (
              'It was mended.'
            ) : (
              <>
                <Link className="link" to="/takes/$takeId" params={{ takeId: mend.new_take_id }}>
                  Version {mend.becomes}
                </Link>{' '}
                is its mend{mend.used_by ? `, with the consent of ${mend.used_by.name}` : ''}. {mend.says}
              </>
            )}
          </span>
        </p>
      )
    case 'none':
      return null
  }
}

/** Levels and length, before and mended. */
function Moved({ mend }: { mend: Mend }) {
  const moved = movedFigures(mend)
  if (moved.length === 0) return null
  return (
    <dl className={`${classes.moved} small`} aria-label="What changes">
      {moved.map(({ what, before, after }) => (
        <div key={what}>
          <dt className="dim">{what}</dt>
          <dd>
            <span className="mid">{before}</span> <span aria-hidden="true">→</span>
            <span className="visually-hidden">becomes</span> <span className="strong">{after}</span>
          </dd>
        </div>
      ))}
    </dl>
  )
}
