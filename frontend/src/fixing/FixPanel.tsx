import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import type { FindingMark, Player } from '@/audio'
import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'

import type { Fix } from './api'
import classes from './Fix.module.css'
import { FixWaves } from './FixWaves'
import type { FixedTake, Fixing } from './useFixing'
import { movedFigures, describeNextStep } from './words'

interface FixPanelProps {
  take: FixedTake
  durationS: number | null
  peaksUrl: string | null
  fixing: Fixing
  player: Player
  findings: readonly FindingMark[]
  limitDbfs?: number
  /** Only the sound's own designer takes a fix; others see that it is offered. */
  mayUse: boolean
  /** What stands where the two waves will, until there are two. */
  children?: ReactNode
  /** Further buttons, after the fix's own. */
  actions?: ReactNode
  /** What stands at the end of the buttons while no fix is there to say it. */
  follows?: ReactNode
}

/** What a fix does about a take: before and fixed, to see, to hear and to compare, and the way to take it. */
export function FixPanel(props: FixPanelProps) {
  const { take, durationS, peaksUrl, fixing, player, findings, limitDbfs, mayUse, children, actions, follows } = props
  const { fix, sound, error } = fixing
  const isMade = fix?.state === 'made'
  return (
    <>
      {isMade && sound !== null && durationS !== null ? (
        <FixWaves
          before={{ name: take.name, durationS, peaksUrl }}
          fix={fix}
          sound={sound}
          fixing={fixing}
          player={player}
          findings={findings}
          limitDbfs={limitDbfs}
        />
      ) : (
        children
      )}
      {fix && isMade && <Moved fix={fix} />}
      {fix && <CueProgress fix={fix} mayUse={mayUse} />}
      <Refusal error={error} />
      {(mayUse || actions || isMade) && (
        <div className={`row wrap mt-3 ${classes.actions}`}>
          {mayUse && <Consent fixing={fixing} />}
          {isMade && sound !== null && (
            <Button icon="ab" keys="b" onClick={fixing.flip}>
              {fixing.side === 'fixed' ? 'Play original' : 'Play fixed'}
            </Button>
          )}
          {actions}
          <span className={`small mid flex-1 num ${classes.follows}`}>
            {isMade && mayUse ? describeNextStep(fix, take.number) : follows}
          </span>
        </div>
      )}
    </>
  )
}

/** The button that says yes: to make the copy first, then to use it. */
function Consent({ fixing }: { fixing: Fixing }) {
  const { fix, isAsking, isUsing } = fixing
  if (fix?.state === 'made') {
    return (
      <Button variant="primary" icon="spanner" keys="t" disabled={isUsing} onClick={fixing.use}>
        Use auto-fix
      </Button>
    )
  }
  if (fix?.state === 'offered' || fix?.is_our_fault) {
    return (
      <Button variant="primary" icon="spanner" keys="t" disabled={isAsking} onClick={fixing.ask}>
        Make auto-fix
      </Button>
    )
  }
  return null
}

/** How far a fix is, in words. */
function CueProgress({ fix, mayUse }: { fix: Fix; mayUse: boolean }) {
  switch (fix.state) {
    case 'making':
      return (
        <p className={`flex items-start gap-2 ${classes.says}`} role="status">
          <Icon name="turning" /> Making the fixed copy. The version itself is not changed.
        </p>
      )
    case 'offered':
    case 'made':
      return (
        <p className={`flex items-start gap-2 ${classes.says}`}>
          <Icon name="spanner" />
          <span>
            {fix.state === 'offered' ? 'Auto-fix: ' : ''}
            {fix.state === 'offered' ? fix.says.charAt(0).toLowerCase() + fix.says.slice(1) : fix.says}
            {!mayUse && ' The designer decides whether to use it.'}
          </span>
        </p>
      )
    case 'refused':
      return (
        <p className={`flex items-start gap-2 ${classes.says}`}>
          <Icon name="spanner" />
          <span>{fix.says}</span>
        </p>
      )
    case 'used':
      return (
        <p className={`flex items-start gap-2 ${classes.says}`}>
          <Icon name="tick" />
          <span>
            {fix.new_take_id === null ? (
              'It was fixed.'
            ) : (
              <>
                <Link className="link" to="/takes/$takeId" params={{ takeId: fix.new_take_id }}>
                  Version {fix.becomes}
                </Link>{' '}
                is its fix{fix.used_by ? `, with the consent of ${fix.used_by.name}` : ''}. {fix.says}
              </>
            )}
          </span>
        </p>
      )
    case 'none':
      return null
  }
}

/** Levels and length, before and fixed. */
function Moved({ fix }: { fix: Fix }) {
  const moved = movedFigures(fix)
  if (moved.length === 0) return null
  return (
    <dl className={`flex wrap ${classes.moved} small`} aria-label="What changes">
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
