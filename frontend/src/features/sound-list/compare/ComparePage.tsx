import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { listQuery } from '@/api/soundList'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { clock, day, plural } from '@/ui/format'
import { Select } from '@/ui/Select'
import { ShowMore } from '@/ui/ShowMore'

import { compareQuery, type Difference, type Revision, revisionsQuery } from '../api'
import { Changes } from '../Changes'
import classes from './Compare.module.css'

/** Two revisions of the list side by side: what was added, changed and cut. */
export function ComparePage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const search: { from?: number; to?: number } = useSearch({ strict: false })
  const navigate = useNavigate()
  useTitle('Compare revisions')
  const { data: list, error: listError } = useQuery(listQuery(projectId))
  const revisions = useInfiniteQuery(revisionsQuery(projectId))
  const newest = list?.revision ?? 0
  const to = Math.min(search.to ?? newest, newest)
  const from = Math.min(search.from ?? Math.max(0, to - 1), to)
  const compared = useQuery({ ...compareQuery(projectId, from, to), enabled: list !== undefined && newest > 0 })
  const known = revisions.data?.pages.flatMap(({ items }) => items) ?? []

  const show = (next: { from: number; to: number }) =>
    void navigate({
      to: '/projects/$projectId/sound-list/compare',
      params: { projectId },
      search: next,
      replace: true,
      resetScroll: false,
    })
  const step = (by: 1 | -1) => {
    const next = Math.min(newest, Math.max(1, to + by))
    show({ from: next - 1, to: next })
  }
  useHotkeys([
    {
      keys: 'Escape',
      label: 'Back to the list',
      group: 'Compare',
      run: () => void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } }),
    },
    { keys: 'j', label: 'Older revision', group: 'Compare', run: () => step(-1), repeats: true },
    { keys: 'k', label: 'Newer revision', group: 'Compare', run: () => step(1), repeats: true },
  ])

  const nothing =
    compared.data && compared.data.added.length + compared.data.changed.length + compared.data.cut.length === 0
  return (
    <div className="page stack content-start">
      <header className="flex wrap items-start between gap-2">
        <div>
          <h1>Compare revisions</h1>
          <p className="mid" role="status">
            {compared.data && inWords(compared.data.added, compared.data.changed, compared.data.cut, from, to)}
          </p>
        </div>
        <ButtonLink component={Link} to={`/projects/${projectId}/sound-list`} keys="Escape">
          Back to the list
        </ButtonLink>
      </header>
      <Refusal error={compared.error ?? revisions.error ?? listError} />
      {list?.revision === 0 && (
        <EmptyState head="No revisions yet">Adding the first cues creates revision 1.</EmptyState>
      )}
      {newest > 0 && (
        <div className="columns side-356">
          <div className="stack">
            <Card aria-label="Revisions to compare" className={`grid grid-cols-2 gap-3 ${classes.choose}`}>
              <RevisionSelect
                label="From"
                value={from}
                first={0}
                last={to}
                known={known}
                onChange={(value) => show({ from: value, to })}
              />
              <RevisionSelect
                label="To"
                value={to}
                first={Math.max(1, from)}
                last={newest}
                known={known}
                onChange={(value) => show({ from, to: value })}
              />
            </Card>
            {nothing && <EmptyState head={`Revisions ${from} and ${to} are identical.`} />}
            {compared.data && (
              <>
                <Differences title="Added" lines={compared.data.added} projectId={projectId} fresh />
                <Differences title="Changed" lines={compared.data.changed} projectId={projectId} />
                <Differences title="Cut" lines={compared.data.cut} projectId={projectId} />
              </>
            )}
          </div>
          <Card aria-labelledby="revisions">
            <CardHead id="revisions" title="Revisions" count={newest} end="newest first" />
            <ol className={classes.revisions}>
              {known.map((revision) => (
                <li key={revision.number}>
                  <Link
                    to="/projects/$projectId/sound-list/compare"
                    params={{ projectId }}
                    search={{ from: revision.number - 1, to: revision.number }}
                    replace
                    resetScroll={false}
                    aria-current={revision.number === to && from === to - 1 ? 'true' : undefined}
                  >
                    <span className="mono dim num">{revision.number}</span>
                    <span className="grow">
                      <span className="cut-text">{revision.summary}</span>
                      <span className="small dim">
                        {revision.author.name}, {day(revision.created_at)}, {clock(revision.created_at)}
                      </span>
                    </span>
                  </Link>
                </li>
              ))}
            </ol>
            {revisions.hasNextPage && (
              <p className="p-2-inset-3">
                <ShowMore list={revisions}>Older revisions</ShowMore>
              </p>
            )}
          </Card>
        </div>
      )}
    </div>
  )
}

function inWords(
  added: readonly Difference[],
  changed: readonly Difference[],
  cut: readonly Difference[],
  from: number,
  to: number,
): string {
  const parts = [
    added.length > 0 ? `${added.length} added` : '',
    changed.length > 0 ? `${changed.length} changed` : '',
    cut.length > 0 ? `${cut.length} cut` : '',
  ].filter(Boolean)
  const since = from === 0 ? `In the list of revision ${to}` : `From revision ${from} to ${to}`
  return `${since}: ${parts.join(', ') || 'no differences'}.`
}

interface RevisionSelectProps {
  label: string
  value: number
  first: number
  last: number
  known: readonly Revision[]
  onChange: (value: number) => void
}

function RevisionSelect({ label, value, first, last, known, onChange }: RevisionSelectProps) {
  const summaries = new Map(known.map(({ number, summary }) => [number, summary]))
  const word = (number: number) =>
    number === 0 ? 'Empty list' : `Revision ${number}${summaries.has(number) ? `: ${summaries.get(number)}` : ''}`
  return (
    <Select label={label} value={value} onChange={({ currentTarget }) => onChange(Number(currentTarget.value))}>
      {Array.from({ length: last - first + 1 }, (_, place) => last - place).map((number) => (
        <option key={number} value={number}>
          {word(number)}
        </option>
      ))}
    </Select>
  )
}

interface DifferencesProps {
  title: string
  lines: readonly Difference[]
  projectId: string
  fresh?: boolean
}

function Differences({ title, lines, projectId, fresh = false }: DifferencesProps) {
  if (lines.length === 0) return null
  const id = `compare-${title}`
  return (
    <Card aria-labelledby={id}>
      <CardHead id={id} title={title} end={plural(lines.length, 'cue')} />
      <ul>
        {lines.map((line) => (
          <li key={line.id} className={`grid items-baseline min-h-28px border-b ${classes.line}`}>
            <span className="mono dim">{line.label}</span>
            <Link
              className="link strong"
              to="/projects/$projectId/sound-list/cues/$cueId"
              params={{ projectId, cueId: line.id }}
            >
              {line.name}
            </Link>
            <div className={`small p-1-0 wrap-anywhere ${classes.changes}`}>
              {line.cut_reason ? (
                <p>Cut: “{line.cut_reason}”</p>
              ) : (
                <Changes changes={line.changes.filter(({ field }) => !fresh || field !== 'name')} fresh={fresh} />
              )}
            </div>
          </li>
        ))}
      </ul>
    </Card>
  )
}
