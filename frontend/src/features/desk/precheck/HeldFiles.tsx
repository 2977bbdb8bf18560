import { useEffect, useMemo, useRef, useState, useSyncExternalStore } from 'react'

import { HotkeyButton } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'

import type { HeldFile } from './held'
import classes from './HeldFiles.module.css'
import { HeldRow } from './HeldRow'
import type { Precheck } from './precheck'
import { isChanged, isRenamable, nameProblems, renamesHere, heldStateOf } from './renames'

const SHOWN = 40

/** Files that wait for a decision before they are sent: what is wrong, how to fix it, and what to do with them. */
export function HeldFiles({ precheck }: { precheck: Precheck }) {
  const state = useSyncExternalStore(precheck.subscribe, precheck.get)
  const { held, isRenaming, judged, dropped, passed, labels } = state
  const [shown, setShown] = useState(SHOWN)
  const [problem, setProblem] = useState<unknown>(null)
  const isChecking = judged < dropped
  useUnloadWarning(isChecking || held.length > 0)
  const isDecisionDue = !isChecking && held.length > 0
  const problems = useMemo(() => nameProblems(held), [held])
  const wrong = held.filter((file) => heldStateOf(file) === 'wrong').length
  const fixable = held.filter((file) => heldStateOf(file) === 'fixable')
  const unnamed = held.filter((file) => heldStateOf(file) === 'unnamed').length
  const ready = held.filter((file) => heldStateOf(file) === 'ready')
  const toRename = held.filter((file) => isRenamable(file) && isChanged(file))
  const renames = renamesHere(state).length
  const region = useRef<HTMLElement>(null)
  const undoButton = useRef<HTMLButtonElement>(null)
  useEffect(() => {
    // The button that renamed all is gone.
    if (renames > 0 && document.activeElement === document.body) undoButton.current?.focus()
  }, [renames])
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
  const rename = (files: readonly HeldFile[]) => void send(() => precheck.rename(files))
  const counts = [
    wrong > 0 ? `${plural(wrong, 'file')} would come back` : '',
    fixable.length > 0 ? `${plural(fixable.length, 'file')} fixable after the upload` : '',
    unnamed > 0 ? `${plural(unnamed, 'file')} without a cue` : '',
    ready.length > 0 ? `${plural(ready.length, 'renamed file')} ready` : '',
  ].filter(Boolean)
  const leaveOut = (files: readonly HeldFile[]) => {
    precheck.leaveOut(files)
    showToast(`${plural(files.length, 'file')} left out. Nothing was uploaded.`, () => {
      precheck.putBack(files)
      return Promise.resolve()
    })
  }
  return (
    <section ref={region} className="grid gap-2 border-b p-3-inset" aria-label="Check before the upload">
      <div className={`row wrap ${classes.bar}`}>
        {wrong > 0 && <StatusBadge kind="returned">{plural(wrong, 'file')} would come back</StatusBadge>}
        {fixable.length > 0 && (
          <StatusBadge kind="fixable">{plural(fixable.length, 'file')} fixable after the upload</StatusBadge>
        )}
        {unnamed > 0 && <StatusBadge kind="unmatched">{plural(unnamed, 'file')} without a cue</StatusBadge>}
        {ready.length > 0 && <StatusBadge kind="passed">{plural(ready.length, 'renamed file')} ready</StatusBadge>}
        {isChecking && (
          <StatusBadge kind="checking">
            {judged} of {plural(dropped, 'file')} checked before the upload
          </StatusBadge>
        )}
        <span className="grow" />
        {toRename.length > 0 && (
          <HotkeyButton
            keys="shift+r"
            keyLabel="Rename all to the list’s names"
            keyGroup="Files before the upload"
            aria-busy={isRenaming}
            onPress={() => rename(toRename)}
          >
            Rename all to the list’s names
          </HotkeyButton>
        )}
        {renames > 0 && (
          <Button ref={undoButton} variant="quiet" onClick={() => precheck.undoRename()}>
            Undo renaming
          </Button>
        )}
        {ready.length > 0 && (
          <Button variant="primary" onClick={() => void send(() => precheck.send(ready))}>
            Upload {plural(ready.length, 'renamed file')}
          </Button>
        )}
        {fixable.length > 1 && (
          <Button onClick={() => void send(() => precheck.send(fixable))}>
            Upload {plural(fixable.length, 'fixable file')}
          </Button>
        )}
        {(isChecking || wrong + unnamed > 0 || (ready.length > 0 && fixable.length > 0)) && (
          <Button onClick={() => void send(() => precheck.sendAll())}>
            {held.length > 0 ? (wrong + unnamed > 0 ? 'Upload all anyway' : 'Upload all') : 'Upload without this check'}
          </Button>
        )}
        {held.length > 1 && (
          <Button variant="quiet" onClick={() => leaveOut(held)}>
            Leave out all {held.length}
          </Button>
        )}
      </div>
      <span className="visually-hidden" role="status">
        {isDecisionDue && `${counts.join(', ')}. Nothing of ${held.length === 1 ? 'it' : 'them'} was uploaded.`}
      </span>
      {problem !== null && <Refusal error={problem} />}
      {held.length > 0 && (
        <p className="small mid">
          {held.length === 1 ? 'It was' : 'They were'} not uploaded.{' '}
          {problems.size > 0 && `${plural(problems.size, 'name')} cannot be used yet; the fields say why. `}
          {passed > 0 && `${plural(passed, 'other file')} passed and ${passed === 1 ? 'is' : 'are'} on the way. `}
          Checked in this browser: {labels.map((label) => label.toLowerCase()).join(', ')}. The other checks are made
          after the upload.
        </p>
      )}
      {held.length > 0 && (
        <ul aria-label="Files that wait for your decision" className="grid">
          {held.slice(0, shown).map((file) => (
            <HeldRow
              key={file.id}
              file={file}
              problem={problems.get(file.id)}
              onWant={(name) => precheck.want(file.id, name)}
              onRename={() => rename([file])}
              onSend={() => void send(() => precheck.send([file]))}
              onLeaveOut={() => leaveOut([file])}
            />
          ))}
        </ul>
      )}
      {held.length > shown && (
        <div className={`row wrap ${classes.bar}`}>
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
