import { Checkbox, Textarea } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { useMyProject } from '@/api/me'
import { queryKeys } from '@/api/queryKeys'
import { keepDraft, keptDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { RefusedNamesList } from '@/app/RefusedNames'
import { SampleOffer } from '@/app/SampleProject'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FieldError } from '@/ui/FieldError'
import { figure, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import { importSheet, useImport } from '../import/api'
import { EMPTY_SHEET, keepSheet } from '../import/pasted'
import classes from './EmptyList.module.css'
import { isTable, LINE_COLUMNS, readSoundLines, sheetOfLines } from './soundLines'

const TYPING_MS = 300

interface EmptyListProps {
  mayEdit: boolean
  onImport: () => void
}

/** What to do with a sound list that has no cue yet. */
export function EmptyList({ mayEdit, onImport }: EmptyListProps): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  if (!mayEdit) {
    return <EmptyState head="The sound list is empty">The team has not added any cues yet.</EmptyState>
  }
  return <FirstSounds projectId={projectId} onImport={onImport} />
}

/** One field that takes names, one a line, or cells of a spreadsheet; beside it the cues that they make. */
function FirstSounds({ projectId, onImport }: { projectId: string; onImport: () => void }) {
  const navigate = useNavigate()
  const project = useMyProject(projectId)
  const draftKey = `first-sounds:${projectId}`
  const [text, setText] = useState(() => keptDraft<string>(draftKey) ?? '')
  const [usesProposedNames, setUsesProposedNames] = useState(true)
  const [typed] = useDebouncedValue(text, TYPING_MS)
  const lines = readSoundLines(text)
  const bodyOf = (content: string) => ({
    format: 'csv' as const,
    text: sheetOfLines(readSoundLines(content)),
    mapping: LINE_COLUMNS,
    match: 'add' as const,
    atomic: true,
  })
  const plan = useQuery({
    queryKey: queryKeys.importPlan(projectId, bodyOf(typed)),
    queryFn: () => importSheet(projectId, { ...bodyOf(typed), dry_run: true }),
    enabled: typed.trim() !== '',
    placeholderData: keepPreviousData,
    gcTime: 0,
    retry: false,
  })
  const add = useImport(projectId)
  const read = lines.length > 0 ? plan.data : undefined
  const isStale = typed !== text || plan.isFetching || plan.isPlaceholderData
  const proposed = new Map(read?.refused_names.names.map(({ row, proposed: name }) => [row, name]))

  const change = (next: string) => {
    if (isTable(next)) {
      keepSheet(projectId, { ...EMPTY_SHEET, text: next }, true)
      keepDraft(draftKey, null)
      void navigate({ to: '/projects/$projectId/sound-list/import', params: { projectId } })
      return
    }
    setText(next)
    keepDraft(draftKey, next === '' ? null : next)
    add.reset()
  }
  const save = () => {
    if (lines.length === 0 || add.isPending) return
    add.mutate(
      { ...bodyOf(text), use_proposed_names: usesProposedNames },
      {
        onSuccess: ({ imported, added }) => {
          if (!imported) return void plan.refetch()
          keepDraft(draftKey, null)
          showToast(`${plural(added, 'cue')} added.`)
        },
      },
    )
  }
  useHotkeys([{ keys: 'mod+Enter', label: 'Add the sounds', group: 'List', run: save }])

  return (
    <section className={`grid gap-4 ${classes.first}`} aria-labelledby="first-sounds">
      <h2 id="first-sounds" className="title">
        Which sounds do you need?
      </h2>
      <Card aria-label="Sounds to add" className={classes.sheet}>
        <Textarea
          label="One sound a line, or paste from a spreadsheet"
          placeholder={'Shield hit\nAirlock cycle: door of the ship, 3 s\nFootsteps on deck x6'}
          rows={8}
          value={text}
          onChange={({ currentTarget }) => change(currentTarget.value)}
        />
        <div
          className={`p-3-4 bg-surface border-l ${classes.preview}`}
          aria-busy={isStale && lines.length > 0 ? true : undefined}
        >
          <p className="small mid">{lines.length === 0 ? 'A name is enough.' : plural(lines.length, 'sound')}</p>
          <ul>
            {lines.map(({ name, durationS, variations }, index) => (
              <li key={index}>
                <span className="strong cut-text">{name}</span>
                <span className="small mid">
                  {[
                    durationS !== null && `${figure(durationS, 2)} s`,
                    variations > 1 && plural(variations, 'variation'),
                  ]
                    .filter(Boolean)
                    .join(', ')}
                </span>
              </li>
            ))}
          </ul>
        </div>
      </Card>
      {read && (
        <>
          {read.errors.map(({ row, message }) => (
            <FieldError
              key={`${row} ${message}`}
            >{`${lines[row - 2]?.name ?? `Line ${row - 1}`}: ${message}`}</FieldError>
          ))}
          <RefusedNamesList refused={read.refused_names}>
            {[...proposed.values()].some(Boolean) && (
              <Checkbox
                label="Use the file names that the spec accepts"
                checked={usesProposedNames}
                onChange={({ currentTarget }) => setUsesProposedNames(currentTarget.checked)}
              />
            )}
          </RefusedNamesList>
        </>
      )}
      <Refusal error={add.error ?? plan.error} />
      <div className="row wrap">
        <Button
          variant="primary"
          keys="mod+Enter"
          disabled={lines.length === 0}
          aria-busy={add.isPending}
          onClick={save}
        >
          {lines.length === 0 ? 'Add sounds' : `Add ${plural(lines.length, 'sound')}`}
        </Button>
        <Button icon="upload" keys="i" onClick={onImport}>
          XLSX or CSV
        </Button>
        <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/kits`}>
          Start from a kit
        </ButtonLink>
        <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/adopt`}>
          Import existing game audio
        </ButtonLink>
      </div>
      {project?.is_producer && !project.is_sample && <SampleOffer studioId={project.studio_id} />}
    </section>
  )
}
