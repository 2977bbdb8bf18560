import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Count } from '@/ui/Count'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'
import { languageName } from '@/voice-lines'

import { scriptQuery, type Script } from './api'
import { CastView } from './CastView'
import { LinesView } from './LinesView'
import { PickUpsView } from './PickUpsView'
import type { LinesSearch, View } from './search'
import classes from './VoiceLines.module.css'

const VIEW_NAMES: readonly { value: View; label: string }[] = [
  { value: 'lines', label: 'Lines' },
  { value: 'pick-ups', label: 'Pick-ups' },
  { value: 'cast', label: 'Cast and releases' },
]

/** The script in one language, what must still be recorded of it, and who speaks. */
export function VoiceLinesPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const search = useSearch({ from: '/shell/projects/$projectId/voice-lines' })
  const navigate = useNavigate()
  const script = useQuery(scriptQuery(projectId))
  useTitle('Voice lines')
  const change = (next: Partial<LinesSearch>) =>
    void navigate({
      to: '/projects/$projectId/voice-lines',
      params: { projectId },
      search: { ...search, ...next },
      replace: true,
    })
  const view = search.view ?? 'lines'
  const toImport = () => void navigate({ to: '/projects/$projectId/voice-lines/import', params: { projectId } })
  const mayChange = script.data?.may_change ?? false
  useHotkeys([
    { keys: 'i', label: 'Import a script', group: 'Voice lines', run: toImport, disabled: !mayChange },
    ...VIEW_NAMES.map(({ value, label }, index) => ({
      keys: String(index + 1),
      label,
      group: 'Voice lines',
      run: () => change({ view: value }),
    })),
  ])
  return (
    <div className={`page stack content-start ${classes.page}`} aria-busy={script.isPending}>
      <header className="flex wrap items-center gap-2-3">
        <h1>Voice lines</h1>
        {script.data && script.data.lines > 0 && <Count of={script.data.lines} />}
        <span className={`end ${classes.acts}`}>
          {script.data && script.data.lines > 0 && (
            <ButtonLink component="a" href={`/v1/projects/${projectId}/voice-lines.csv`} icon="download">
              Export CSV
            </ButtonLink>
          )}
          {mayChange && (
            <ButtonLink
              component={Link}
              to={`/projects/${projectId}/voice-lines/import`}
              variant="primary"
              icon="upload"
              keys="i"
            >
              Import a script
            </ButtonLink>
          )}
        </span>
      </header>
      <Refusal error={script.error} />
      {script.data?.lines === 0 ? (
        <EmptyState head="No voice lines yet">
          {mayChange
            ? 'Import a script: a sheet with character, text and languages, or plain text with names in capitals. Each line gets a cue in the sound list for each of its languages.'
            : 'The team has not imported a script yet.'}
        </EmptyState>
      ) : (
        script.data && (
          <>
            <div className={classes.tools}>
              <Segmented label="View" options={VIEW_NAMES} value={view} onChange={(next) => change({ view: next })} />
              {view !== 'cast' && <Narrow script={script.data} search={search} view={view} onChange={change} />}
            </div>
            {view === 'lines' && (
              <LinesView projectId={projectId} script={script.data} search={search} onChange={change} />
            )}
            {view === 'pick-ups' && <PickUpsView projectId={projectId} search={search} />}
            {view === 'cast' && <CastView projectId={projectId} script={script.data} />}
          </>
        )
      )}
    </div>
  )
}

interface NarrowProps {
  script: Script
  search: LinesSearch
  view: View
  onChange: (next: Partial<LinesSearch>) => void
}

function Narrow({ script, search, view, onChange }: NarrowProps) {
  const { languages, characters, original_language: original } = script
  const isLines = view === 'lines'
  return (
    <>
      <Select
        aria-label="Language"
        value={search.language ?? (isLines ? original : '')}
        onChange={(event) => onChange({ language: event.currentTarget.value || undefined })}
      >
        {!isLines && <option value="">All languages</option>}
        {[...new Set([...languages, ...(isLines ? [original] : [])])].map((language) => (
          <option key={language} value={language}>
            {languageName(language)}
          </option>
        ))}
      </Select>
      <Select
        aria-label="Character"
        value={search.character ?? ''}
        onChange={(event) => onChange({ character: event.currentTarget.value || undefined })}
      >
        <option value="">All characters</option>
        {characters.map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </Select>
    </>
  )
}
