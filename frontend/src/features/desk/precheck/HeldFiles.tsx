import { useEffect, useRef, useState, useSyncExternalStore } from 'react'

import { showToast } from '@/app/toast'
import { wordsOf } from '@/judging/findings'
import { Refusal } from '@/judging/Refusal'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { State } from '@/ui/State'

import type { Finding } from './checks'
import classes from './HeldFiles.module.css'
import type { HeldFile, Precheck } from './precheck'

const SHOWN = 40

/** Files that would come back, before they are sent: what is wrong, how to fix it, and what to do with them. */
export function HeldFiles({ precheck }: { precheck: Precheck }) {
  const { held, judged, dropped, passed, labels } = useSyncExternalStore(precheck.subscribe, precheck.get)
  const [shown, setShown] = useState(SHOWN)
  const [problem, setProblem] = useState<unknown>(null)
  const isChecking = judged < dropped
  useUnloadWarning(isChecking || held.length > 0)
  const isDecisionDue = !isChecking && held.length > 0
  const region = useRef<HTMLElement>(null)
  useEffect(() => {
    // The card of the delivery may be far below what came back.
    if (isDecisionDue) region.current?.scrollIntoView({ block: 'nearest' })
  }, [isDecisionDue])
  if (!isChecking && held.length === 0 && problem === null) return null

  const send = async (sending: () => Promise<void>) => {
    setProblem(null)
    try {
      await sending()
    } catch (refusal) {
      setProblem(refusal)
    }
  }
  const leaveOut = (files: readonly HeldFile[]) => {
    precheck.leaveOut(files)
    showToast(`${plural(files.length, 'file')} left out. Nothing was uploaded.`, () => {
      precheck.putBack(files)
      return Promise.resolve()
    })
  }
  return (
    <section ref={region} className={classes.held} aria-label="Check before the upload">
      <div className={classes.bar}>
        {held.length > 0 && <State kind="returned">{plural(held.length, 'file')} would come back</State>}
        {isChecking && (
          <State kind="checking">
            {judged} of {plural(dropped, 'file')} checked before the upload
          </State>
        )}
        <span className="grow" />
        <Button onClick={() => void send(() => precheck.sendAll())}>
          {held.length > 0 ? 'Upload all anyway' : 'Upload without this check'}
        </Button>
        {held.length > 1 && (
          <Button variant="quiet" onClick={() => leaveOut(held)}>
            Leave out all {held.length}
          </Button>
        )}
      </div>
      <span className="visually-hidden" role="status">
        {isDecisionDue &&
          `${plural(held.length, 'file')} would come back. Nothing of ${held.length === 1 ? 'it' : 'them'} was uploaded.`}
      </span>
      {problem !== null && <Refusal error={problem} />}
      {held.length > 0 && (
        <p className="small mid">
          {held.length === 1 ? 'It was' : 'They were'} not uploaded.{' '}
          {passed > 0 && `${plural(passed, 'other file')} passed and ${passed === 1 ? 'is' : 'are'} on the way. `}
          Checked in this browser: {labels.map((label) => label.toLowerCase()).join(', ')}. The other checks are made
          after the upload.
        </p>
      )}
      {held.length > 0 && (
        <ul aria-label="Files that would come back" className={classes.files}>
          {held.slice(0, shown).map((file) => (
            <HeldRow
              key={file.id}
              file={file}
              onSend={() => void send(() => precheck.send([file]))}
              onLeaveOut={() => leaveOut([file])}
            />
          ))}
        </ul>
      )}
      {held.length > shown && (
        <div className={classes.bar}>
          <span className="small mid">{held.length - shown} more below</span>
          <button type="button" className="link small mid" onClick={() => setShown(shown + SHOWN)}>
            Show more
          </button>
        </div>
      )}
    </section>
  )
}

/** Ask before the page is closed with files that were dropped and not sent. */
function useUnloadWarning(isWaiting: boolean): void {
  useEffect(() => {
    if (!isWaiting) return
    const warn = (event: BeforeUnloadEvent) => event.preventDefault()
    window.addEventListener('beforeunload', warn)
    return () => window.removeEventListener('beforeunload', warn)
  }, [isWaiting])
}

interface HeldRowProps {
  file: HeldFile
  onSend: () => void
  onLeaveOut: () => void
}

function HeldRow({ file: { picked, cue, findings }, onSend, onLeaveOut }: HeldRowProps) {
  const name = picked.path
  return (
    <li className={classes.file}>
      <div className={classes.said}>
        <span className={classes.name}>
          <span className="mono strong">{name}</span> <span className="mono dim">{cue}</span>
        </span>
        {findings.map((finding) => (
          <FindingLine key={finding.code} finding={finding} />
        ))}
      </div>
      <span className={classes.does}>
        <Button aria-label={`Upload anyway: ${name}`} onClick={onSend}>
          Upload anyway
        </Button>
        <Button variant="quiet" aria-label={`Leave out ${name}`} onClick={onLeaveOut}>
          Leave out
        </Button>
      </span>
    </li>
  )
}

function FindingLine({ finding }: { finding: Finding }) {
  const { head, rest, where } = wordsOf({ ...finding, check: '', waived: false })
  return (
    <p className={`${classes.finding} tone-${finding.severity === 'error' ? 'bad' : 'warn'}`}>
      <span className="strong toned">
        <span className="visually-hidden">{finding.severity === 'error' ? 'Error: ' : 'Warning: '}</span>
        {head}.
      </span>{' '}
      <span className="mid">
        {rest}
        {where !== '' && ` At ${where}.`}
      </span>
    </p>
  )
}
