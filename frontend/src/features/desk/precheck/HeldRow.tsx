import { TextInput } from '@mantine/core'
import type { FormEvent } from 'react'

import { Button } from '@/ui/Button'
import { StatusBadge } from '@/ui/StatusBadge'

import { fixInWords, isAllFixed } from '@/precheck/autoFix'
import { FindingLine } from '@/precheck/FindingLine'
import classes from './HeldFiles.module.css'
import type { HeldFile } from './held'
import { isRenamable, heldStateOf } from './renames'

interface HeldRowProps {
  file: HeldFile
  problem: string | undefined
  onWant: (name: string) => void
  onRename: () => void
  onSend: () => void
  onLeaveOut: () => void
}

/** One file that waits for a decision. */
export function HeldRow({ file, problem, onWant, onRename, onSend, onLeaveOut }: HeldRowProps) {
  const { cue, findings, firstName, wanted } = file
  const name = file.picked.path
  const standing = heldStateOf(file)
  const rename = (event: FormEvent) => {
    event.preventDefault()
    onRename()
  }
  return (
    <li
      className={`grid items-start gap-2-4 border-t wrap-anywhere grid-cols-1-auto narrow-grid-cols-1 ${classes.file}`}
    >
      <div className="grid gap-2px">
        <span className={classes.name}>
          <span className="mono strong">{name}</span> <span className="mono dim">{cue}</span>
        </span>
        {firstName !== null && (
          <span className={`${classes.name} small mid`}>
            Renamed from <span className="mono">{firstName}</span>
          </span>
        )}
        {findings.map((finding) => (
          <FindingLine
            key={finding.code}
            finding={finding}
            fix={standing === 'fixable' && isAllFixed(finding) ? '' : finding.fix}
          />
        ))}
        {standing === 'fixable' && (
          <p>
            <StatusBadge kind="fixable" />{' '}
            <span className="mid">
              {cue === '' ? 'Once its cue is chosen, a' : 'A'} fix {fixInWords(findings)}. It is offered on this desk
              after the upload; you hear it first, and your file is kept.
            </span>
          </p>
        )}
        {standing === 'unnamed' && (
          <p className="tone-warn">
            <span className="strong toned">The name does not say which cue it is for.</span>{' '}
            <span className="mid">Rename it, or upload it and choose its cue among the unmatched files.</span>
          </p>
        )}
        {standing === 'ready' && <StatusBadge kind="passed">Passes under this name</StatusBadge>}
        {isRenamable(file) && (
          <form className={classes.rename} onSubmit={rename} noValidate>
            <TextInput
              aria-label={`New name of ${name}`}
              value={wanted}
              error={problem}
              spellCheck={false}
              autoComplete="off"
              onChange={({ currentTarget }) => onWant(currentTarget.value)}
            />
            <Button type="submit" aria-label={`Rename ${name}`}>
              Rename
            </Button>
          </form>
        )}
      </div>
      <span className={`flex wrap gap-2 ${classes.does}`}>
        {standing === 'ready' || standing === 'fixable' ? (
          <Button aria-label={`Upload ${name}`} onClick={onSend}>
            Upload
          </Button>
        ) : (
          <Button aria-label={`Upload anyway: ${name}`} onClick={onSend}>
            Upload anyway
          </Button>
        )}
        <Button variant="quiet" aria-label={`Leave out ${name}`} onClick={onLeaveOut}>
          Leave out
        </Button>
      </span>
    </li>
  )
}
