import { infiniteQueryOptions, queryOptions, useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { useRef } from 'react'

import { unwrap, api, get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago, day, place, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Person } from '@/ui/Person'
import { Select } from '@/ui/Select'
import { ShowMore } from '@/ui/ShowMore'

import type { FoundReasons } from './foundReasons'
import classes from './Reasons.module.css'

type Count = components['schemas']['ReasonCount']
type Found = components['schemas']['ReasonPlaceRead']

const wantedOf = ({ designer, category }: FoundReasons) => ({ designer_id: designer, category })

const countsQuery = (projectId: string, search: FoundReasons) =>
  queryOptions({
    queryKey: queryKeys.reasons(projectId, 'counts', wantedOf(search)),
    queryFn: () =>
      unwrap(
        api.GET('/v1/projects/{project_id}/reasons', {
          params: { path: { project_id: projectId }, query: wantedOf(search) },
        }),
      ),
    placeholderData: (before) => before,
  })

const versionsQuery = (projectId: string, kind: 'change' | 'pick', reason: string, search: FoundReasons) =>
  infiniteQueryOptions({
    queryKey: queryKeys.reasons(projectId, 'versions', { kind, reason, ...wantedOf(search) }),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/reasons/versions', {
        project_id: projectId,
        kind,
        reason,
        ...wantedOf(search),
        cursor,
      }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
    select: ({ pages }) => pages.flatMap(({ items }) => items),
  })

/** How often each reason was given in a project, and of which versions. */
export function ReasonsPage() {
  useTitle('Reasons')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/reasons' })
  const search = useSearch({ from: '/shell/projects/$projectId/reasons' })
  const navigate = useNavigate({ from: '/projects/$projectId/reasons' })
  const { data: counts, error } = useQuery(countsQuery(projectId, search))
  const page = useRef<HTMLDivElement>(null)
  const step = (by: number) => {
    const rows = [...(page.current?.querySelectorAll<HTMLElement>('[data-row]') ?? [])]
    const at = rows.findIndex((row) => row === document.activeElement)
    rows[at < 0 ? (by > 0 ? 0 : rows.length - 1) : Math.min(Math.max(at + by, 0), rows.length - 1)]?.focus()
  }
  useHotkeys([
    { keys: 'j', label: 'Next reason or version', group: 'Reasons', run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous reason or version', group: 'Reasons', run: () => step(-1), repeats: true },
    { keys: 'ArrowDown', label: 'Next', group: 'Reasons', unlisted: true, run: () => step(1), repeats: true },
    { keys: 'ArrowUp', label: 'Previous', group: 'Reasons', unlisted: true, run: () => step(-1), repeats: true },
  ])
  const filter = (chosen: Partial<FoundReasons>) =>
    void navigate({ search: (before) => ({ ...before, ...chosen }), replace: true })
  const isFiltered = search.designer !== undefined || search.category !== undefined
  const isNothing = counts !== undefined && counts.change.length + counts.pick.length === 0
  return (
    <div className="page stack" ref={page} aria-busy={counts === undefined && error === null}>
      <PageHead title="Reasons">How often each reason was given with a verdict, and of which versions.</PageHead>
      <Refusal error={error} />
      {counts && (!isNothing || isFiltered) && (
        <div className="flex wrap gap-3">
          {counts.designers.length > 0 && (
            <Select
              label="Sound designer"
              value={search.designer ?? ''}
              onChange={({ currentTarget: { value } }) => filter({ designer: value || undefined })}
            >
              <option value="">All</option>
              {counts.designers.map(({ id, name }) => (
                <option key={id} value={id}>
                  {name}
                </option>
              ))}
            </Select>
          )}
          <Select
            label="Category"
            value={search.category ?? ALL}
            onChange={({ currentTarget: { value } }) => filter({ category: value === ALL ? undefined : value })}
          >
            <option value={ALL}>All</option>
            {counts.categories.map((category) => (
              <option key={category} value={category}>
                {category || 'None'}
              </option>
            ))}
          </Select>
        </div>
      )}
      {isNothing && !isFiltered && (
        <EmptyState head="No reasons yet">
          In Review, <kbd>p</kbd> and a digit approve with a reason, <kbd>Shift R</kbd> and a digit request a change.
        </EmptyState>
      )}
      {isNothing && isFiltered && (
        <p>
          No reasons here.{' '}
          <Button onClick={() => filter({ designer: undefined, category: undefined })}>Show all</Button>
        </p>
      )}
      {counts && !isNothing && (
        <div className={`columns ${classes.columns}`}>
          <div className="stack">
            <Counts kind="change" title="Why changes were requested" counts={counts.change} search={search} />
            <Counts kind="pick" title="Why versions were approved" counts={counts.pick} search={search} />
          </div>
          {search.kind && search.reason !== undefined && (
            <Versions key={search.reason} kind={search.kind} reason={search.reason} search={search} />
          )}
        </div>
      )}
    </div>
  )
}

const ALL = '\u0000all' // no category is called so

interface CountsProps {
  kind: 'change' | 'pick'
  title: string
  counts: readonly Count[]
  search: FoundReasons
}

function Counts({ kind, title, counts, search }: CountsProps) {
  const { projectId } = useParams({ from: '/shell/projects/$projectId/reasons' })
  return (
    <Card aria-labelledby={`reasons-${kind}`}>
      <CardHead id={`reasons-${kind}`} title={title} />
      {counts.length === 0 && <p className="small mid p-10px-inset">None yet</p>}
      <ul>
        {counts.map(({ reason, versions }) => (
          <li key={reason}>
            <Link
              data-row
              className={`hover narrow-min-h-44px ${classes.row}`}
              to="/projects/$projectId/reasons"
              params={{ projectId }}
              search={{ ...search, kind, reason }}
              aria-current={search.kind === kind && search.reason === reason ? 'true' : undefined}
            >
              <span className="grow">{reason}</span>{' '}
              <span className="num mid nowrap">{plural(versions, 'version')}</span>
            </Link>
          </li>
        ))}
      </ul>
    </Card>
  )
}

interface VersionsProps {
  kind: 'change' | 'pick'
  reason: string
  search: FoundReasons
}

function Versions({ kind, reason, search }: VersionsProps) {
  const { projectId } = useParams({ from: '/shell/projects/$projectId/reasons' })
  const versions = useInfiniteQuery(versionsQuery(projectId, kind, reason, search))
  const { error, data } = versions
  return (
    <Card aria-labelledby="reason-versions">
      <CardHead
        id="reason-versions"
        title={reason}
        note={kind === 'pick' ? 'approved' : 'change requested'}
        end="newest first"
      />
      <Refusal error={error} />
      {data?.length === 0 && <p className="small mid p-10px-inset">No version here</p>}
      <ul>
        {data?.map((version) => (
          <li key={version.verdict_id}>
            <Version version={version} />
          </li>
        ))}
      </ul>
      {versions.hasNextPage && (
        <p className="p-10px-inset">
          <ShowMore list={versions}>More versions</ShowMore>
        </p>
      )}
    </Card>
  )
}

function Version({ version }: { version: Found }) {
  const { cue_label, cue_name, variation, number, label, start_s: startS } = version
  const text = version.text || version.reasons.join('. ')
  return (
    <Link
      data-row
      className={`flex-col wrap-anywhere hover ${classes.version}`}
      to="/takes/$takeId"
      params={{ takeId: version.take_id }}
      search={{ at: startS ?? undefined }}
    >
      <span className="row">
        <span className="mono dim">{cue_label}</span>
        <span className="strong cut-text">{cue_name}</span>
        <span className="small mid nowrap">
          {variation > 1 && `_${String(variation).padStart(2, '0')}, `}
          version {number}
          {label !== null && `, ${label}`}
        </span>
        <time className="small dim end nowrap" dateTime={version.given_at} title={day(version.given_at)}>
          {ago(version.given_at)}
        </time>
      </span>
      <span>
        {startS !== null && <span className="mono dim small">{place(startS)} </span>}
        {text}
      </span>
      <span className="row small mid">
        {version.given_by && <Person name={version.given_by.name} picture={version.given_by.picture} />}
        <span>on a version by {version.designer.name}</span>
      </span>
    </Link>
  )
}
