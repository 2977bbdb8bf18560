import { useDebouncedValue } from '@mantine/hooks'
import { useQueryClient } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import { useEffect, useMemo, useState } from 'react'

import { ApiProblem } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { showToast } from '@/app/toast'

import { type Spec, useSaveSpec, useSpecTry } from '../api'
import { differs, draftOf, keepDraft, keptDraft, type SpecDraft, written } from './draft'
import { hasComments } from './places'
import { same, type Tables } from './tables'
import { troubleOf } from './trouble'

const TRY_AFTER_MS = 400

export type SpecWriting = ReturnType<typeof useSpecDraft>

/** The spec as it is being written: kept at each change, tried by the server shortly after, saved as a version. */
export function useSpecDraft(projectId: string, spec: Spec) {
  const client = useQueryClient()
  const navigate = useNavigate()
  const [draft, setDraft] = useState<SpecDraft>(() => keptDraft(projectId) ?? draftOf(spec))
  const [wasKept, setWasKept] = useState(() => keptDraft(projectId) !== null)
  const save = useSaveSpec(projectId)
  const changed = differs(draft, spec)
  const movedOn = spec.version !== draft.basedOn
  useEffect(() => keepDraft(projectId, changed ? draft : null), [projectId, draft, changed])
  // Nothing was written yet: the newer version is simply the one to write on.
  useEffect(() => {
    if (movedOn && !changed) setDraft((old) => ({ ...draftOf(spec, old.mode), note: old.note }))
  }, [movedOn, changed, spec])

  const sent = useMemo(() => written(draft), [draft])
  const [settled] = useDebouncedValue(sent, TRY_AFTER_MS)
  const isOwn = 'toml' in settled && settled.toml === spec.toml
  const tried = useSpecTry(projectId, settled, changed && !isOwn)
  const isCurrent = same(settled, sent) && !tried.isFetching && !tried.isPlaceholderData
  const trouble = troubleOf(changed ? (troubleOf(save.error) && save.error) || (isCurrent ? tried.error : null) : null)
  const result = changed ? (isCurrent && tried.data ? tried.data : null) : spec
  const mine = 'toml' in sent ? sent.toml : (tried.data?.toml ?? draft.from.toml)

  // A form is compared with what a form would write of the spec, or every comment would count as a change.
  const { data: plain } = useSpecTry(projectId, { tables: spec.tables }, changed && 'tables' in sent)
  const theirs = 'tables' in sent ? plain?.toml : spec.toml

  const change = (next: Partial<SpecDraft>) => {
    save.reset()
    setDraft((old) => ({ ...old, ...next }))
  }
  const changeTables = (change: (tables: Tables) => Tables) => {
    save.reset()
    setDraft((old) => ({ ...old, tables: change(old.tables) }))
  }
  const switchTo = (mode: SpecDraft['mode']) => {
    if (mode === draft.mode) return
    if (mode === 'toml') {
      change({ mode, toml: 'toml' in sent ? sent.toml : mine })
      return
    }
    const tables = draft.toml === spec.toml ? spec.tables : result?.tables
    if (tables === undefined) return
    change({ mode, tables, from: { toml: draft.toml, tables } })
  }
  const begin = (from: SpecDraft) => {
    save.reset()
    setWasKept(false)
    setDraft(from)
  }
  const drop = () => {
    const dropped = draft
    begin(draftOf(spec, draft.mode))
    showToast('Your changes were discarded.', () => begin(dropped))
  }
  /** Save it as the next version, and stay on the page or go to the project. */
  const send = (stays = false) => {
    if (!changed || save.isPending) return
    const before = spec
    save.mutate(
      { ...sent, note: draft.note, based_on_version: draft.basedOn },
      {
        onSuccess: (saved) => {
          keepDraft(projectId, null)
          showToast(`Version ${saved.version} of the spec saved. Affected versions are rechecked.`, async () => {
            await save.mutateAsync({
              toml: before.toml,
              note: `As version ${before.version}`,
              based_on_version: saved.version,
            })
          })
          if (stays) setDraft(draftOf(saved))
          else void navigate({ to: '/projects/$projectId', params: { projectId } })
        },
        onError: (error) => {
          if (error instanceof ApiProblem && error.code === 'spec-changed') {
            void invalidate(client, queryKeys.spec(projectId))
          }
        },
      },
    )
  }
  return {
    draft,
    change,
    changeTables,
    switchTo,
    maySwitch: !changed || result !== null,
    wasRestored: wasKept && changed,
    changed,
    movedOn,
    isCurrent,
    trouble,
    result,
    mine,
    theirs,
    losesComments: 'tables' in sent && hasComments(draft.from.toml),
    save,
    drop,
    send,
  }
}
