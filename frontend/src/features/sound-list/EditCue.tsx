import { useQueryClient } from '@tanstack/react-query'
import { type ReactNode, useEffect, useRef, useState } from 'react'

import type { ApiProblem } from '@/api'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { ProblemNote } from '@/ui/ProblemNote'

import { type Cue, type FieldChange, problemIn, readAgain, useChangeCue } from './api'
import { Changes } from './Changes'
import { CueFields } from './CueFields'
import {
  changedFacts,
  changesBetween,
  type CueDraft,
  type DraftField,
  draftOf,
  type Faults,
  readDraft,
  rebased,
  refusedRows,
  touched,
} from './draft'
import classes from './Panel.module.css'

interface Kept {
  /** As the cue was read when typing began, or after somebody else's change. */
  base: Cue
  draft: CueDraft
}

/** What was typed and not saved, by cue: closing or leaving loses nothing. */
const kept = new Map<string, Kept>()

interface EditCueProps {
  cue: Cue
  projectId: string
  categories: readonly string[]
  onClose: () => void
  /** Beside the buttons: what else can be done with the cue. */
  more?: ReactNode
}

/** Change the facts of a cue in place. */
export function EditCue({ cue, projectId, categories, onClose, more }: EditCueProps) {
  const client = useQueryClient()
  const change = useChangeCue(projectId)
  const [{ base, draft }, setEdit] = useState<Kept>(() => kept.get(cue.id) ?? { base: cue, draft: draftOf(cue) })
  const [faults, setFaults] = useState<Faults>({})
  const [whole, setWhole] = useState<string[]>([])
  const [theirs, setTheirs] = useState<FieldChange[]>([])
  const [refusal, setRefusal] = useState<ApiProblem | null>(null)
  const form = useRef<HTMLFormElement>(null)

  useEffect(() => {
    form.current?.querySelector<HTMLElement>('input')?.focus()
  }, [])

  const mine = touched(base, draft)
  const put = (field: DraftField, value: string | boolean) => {
    const next = { base, draft: { ...draft, [field]: value } }
    setEdit(next)
    setFaults((before) => ({ ...before, [field]: undefined }))
    if (touched(base, next.draft).length > 0) kept.set(cue.id, next)
    else kept.delete(cue.id)
  }

  const takeTheirs = async () => {
    const fresh = await readAgain(client, projectId, cue.id)
    const next = { base: fresh, draft: rebased(base, fresh, draft) }
    setTheirs(changesBetween(base, fresh))
    setEdit(next)
    kept.set(cue.id, next)
  }

  const save = async () => {
    if (change.isPending) return
    const read = readDraft(draft)
    setFaults(read.faults)
    setWhole([])
    setRefusal(null)
    if (Object.keys(read.faults).length > 0) return
    if (mine.length === 0) {
      onClose()
      return
    }
    const facts = changedFacts(base, draft)
    try {
      const saved = await change.mutateAsync({ cueId: cue.id, edition: base.edition, facts })
      kept.delete(cue.id)
      const before = changedFacts(saved, draftOf(base))
      showToast(`${saved.name} changed.`, async () => {
        await change.mutateAsync({ cueId: cue.id, edition: saved.edition, facts: before })
      })
      onClose()
    } catch (error) {
      const problem = problemIn(error)
      if (problem === null) throw error
      if (problem.code === 'cue-edited-meanwhile') {
        await takeTheirs().catch(() => setRefusal(problem))
        return
      }
      const refused = refusedRows(problem).get(0)
      setFaults(refused?.fields ?? {})
      setWhole(refused?.whole ?? [])
      if (refused === undefined) setRefusal(problem)
    }
  }
  useHotkeys([{ keys: 'mod+Enter', label: 'Save the cue', group: 'List', run: () => void save() }])

  const drop = () => {
    kept.delete(cue.id)
    onClose()
  }

  return (
    <form
      ref={form}
      className={classes.panel}
      aria-label={`Edit ${cue.name}`}
      noValidate
      onSubmit={(event) => {
        event.preventDefault()
        void save()
      }}
    >
      {theirs.length > 0 && (
        <div role="alert" className={`${classes.theirs} tone-warn`}>
          <p>
            <span className="strong toned">Somebody else changed {cue.name} meanwhile.</span> What you typed stays as it
            is. Save once more to put it over theirs.
          </p>
          <Changes changes={theirs} />
        </div>
      )}
      <CueFields draft={draft} faults={faults} categories={categories} onChange={put} />
      {whole.map((sentence) => (
        <ProblemNote key={sentence} detail={sentence} />
      ))}
      {refusal && <ProblemNote detail={refusal.detail} fix={refusal.fix} />}
      <div className={classes.acts}>
        {more}
        <span className="small dim end">
          {mine.length > 0 ? 'Not saved yet; closing keeps what you typed.' : 'Nothing is changed.'}
        </span>
        {mine.length > 0 ? (
          <Button onClick={drop}>Drop what I typed</Button>
        ) : (
          <Button keys="Escape" onClick={onClose}>
            Close
          </Button>
        )}
        <Button type="submit" variant="primary" keys="mod+Enter" disabled={change.isPending}>
          Save {cue.name}
        </Button>
      </div>
    </form>
  )
}
