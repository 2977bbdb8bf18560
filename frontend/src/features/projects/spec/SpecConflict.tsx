import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { sentence } from '@/ui/sentence'

import type { Spec } from '../api'
import { LineDiff } from './LineDiff'
import classes from './SpecEditor.module.css'

interface SpecConflictProps {
  spec: Spec
  /** Undefined while it is on its way. */
  theirs: string | undefined
  mine: string
  basedOn: number
  onKeepMine: () => void
  onTakeTheirs: () => void
}

/** Another person saved meanwhile: both texts are shown until one is chosen. */
export function SpecConflict({ spec, theirs, mine, basedOn, onKeepMine, onTakeTheirs }: SpecConflictProps) {
  return (
    <Card className={classes.moved} aria-labelledby="moved">
      <CardHead id="moved" title={`${spec.author.name} saved version ${spec.version} while you were editing`} />
      <div className="grid gap-3 p-inset">
        <p>
          {`You started from version ${basedOn}. Nothing you typed is lost.`}{' '}
          {spec.note !== '' && <span className="mid">{`Their note: ${sentence(spec.note)}`}</span>}
        </p>
        <div className="row wrap">
          <Button variant="primary" onClick={onKeepMine}>{`Keep mine and replace version ${spec.version}`}</Button>
          <Button onClick={onTakeTheirs}>{`Use version ${spec.version} and discard mine`}</Button>
        </div>
      </div>
      {theirs !== undefined && (
        <LineDiff before={theirs} after={mine} label={`Version ${spec.version} compared with yours`} />
      )}
    </Card>
  )
}
