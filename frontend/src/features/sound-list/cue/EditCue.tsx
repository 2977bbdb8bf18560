import { useQuery, useQueryClient } from '@tanstack/react-query'
import { type ReactNode, useEffect, useRef, useState } from 'react'

import type { ApiProblem } from '@/api'
import { DraftNote, keepDraft, keptDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Refusal } from '@/ui/Refusal'

import { type Cue, type FieldChange, problemIn, readAgain, useChangeCue } from '../api'
import { Changes } from '../Changes'
import { columnsQuery } from '../columns/api'
import { CueFields } from './CueFields'
import {
  changedFacts,
  changesBetween,
  type CueDraft,
  type DraftField,
  type DraftValue,
  draftOf,
  type Faults,
  readDraft,
  rebased,
  refusedRows,
  touched,
} from './draft'
import { cuePeopleQuery, withPeopleNames } from '../people'
import classes from './Panel.module.css'

interface Kept {
  /** The cue as read when typing began, or after another person's change. */
  base: Cue
  draft: CueDraft
}

const keyOf = (cue: Cue) => `cue:${cue.id}`

interface EditCueProps {
  cue: Cue
  projectId: string
  categories: readonly string[]
  onClose: () => void
  /** Next to the buttons: further actions on the cue. */
  more?: ReactNode
}

/** Change the facts of a cue in place. */
export function EditCue({ cue, projectId, categories, onClose, more }: EditCueProps) {
  const client = useQueryClient()
  const change = useChangeCue(projectId)
  const { data: columns } = useQuery(columnsQuery(projectId))
  const { data: people } = useQuery(cuePeopleQuery(projectId))
  const [{ base, draft }, setEdit] = useState<Kept>(
    () => keptDraft<Kept>(keyOf(cue)) ?? { base: cue, draft: draftOf(cue) },
  )
  const [wasKept, setWasKept] = useState(() => keptDraft(keyOf(cue)) !== null)
  const [faults, setFaults] = useState<Faults>({})
  const [whole, setWhole] = useState<string[]>([])
  const [theirs, setTheirs] = useState<FieldChange[]>([])
  const [refusal, setRefusal] = useState<ApiProblem | null>(null)
  const form = useRef<HTMLFormElement>(null)

  useEffect(() => {
    form.current?.querySelector<HTMLElement>('input')?.focus()
  }, [])

  const mine = touched(base, draft)
  const put = (field: DraftField, value: DraftValue) => {
    const next = { base, draft: { ...draft, [field]: value } }
    setEdit(next)
    setFaults((before) => ({ ...before, [field]: undefined }))
    keepDraft(keyOf(cue), touched(base, next.draft).length > 0 ? next : null)
  }

  const takeTheirs = async () => {
    const fresh = await readAgain(client, projectId, cue.id)
    const next = { base: fresh, draft: rebased(base, fresh, draft) }
    setTheirs(changesBetween(base, fresh))
    setEdit(next)
    keepDraft(keyOf(cue), next)
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
      keepDraft(keyOf(cue), null)
      const before = changedFacts(saved, draftOf(base))
      showToast(`${saved.name} saved.`, async () => {
        await change.mutateAsync({ cueId: cue.id, edition: saved.edition, facts: before })
      })
      onClose()
    } catch (error) {
      const problem = problemIn(error)
      if (problem === null) throw error
      if (problem.code === 'cue-changed') {
        await takeTheirs().catch(() => setRefusal(problem))
        return
      }
      const refused = refusedRows(problem).get(0)
      setFaults(refused?.fields ?? {})
      setWhole(refused?.whole ?? [])
      if (refused === undefined) setRefusal(problem)
    }
  }
  useHotkeys([{ keys: 'mod+Enter', label: 'Save cue', group: 'List', run: () => void save() }])

  const drop = () => {
    keepDraft(keyOf(cue), null)
    onClose()
  }

  return (
    <form
      ref={form}
      className={`grid gap-3 narrow-p-3 ${classes.panel}`}
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
            <span className="strong toned">Someone else changed {cue.name} meanwhile.</span> Your changes are kept. Save
            again to replace theirs.
          </p>
          <Changes changes={withPeopleNames(theirs, people ?? [])} />
        </div>
      )}
      <DraftNote
        draft={{
          isRestored: wasKept && mine.length > 0,
          discard: () => {
            keepDraft(keyOf(cue), null)
            setWasKept(false)
            setEdit({ base: cue, draft: draftOf(cue) })
          },
        }}
      />
      <CueFields
        projectId={projectId}
        draft={draft}
        faults={faults}
        categories={categories}
        columns={columns?.columns}
        people={people}
        onChange={put}
      />
      {whole.map((sentence) => (
        <ErrorBanner key={sentence} detail={sentence} />
      ))}
      <Refusal error={refusal} />
      <div className="row wrap">
        {more}
        <span className="small dim end">
          {mine.length > 0 ? 'Not saved yet. Your changes are kept if you close.' : 'No changes.'}
        </span>
        {mine.length > 0 ? (
          <Button onClick={drop}>Discard changes</Button>
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
