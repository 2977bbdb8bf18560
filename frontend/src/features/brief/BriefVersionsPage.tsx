import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { shortDay } from '@/ui/format'
import { Select } from '@/ui/Select'
import { ShowMore } from '@/ui/ShowMore'

import { comparisonQuery, useBriefVersions } from './api'
import classes from './Brief.module.css'

const NOW = 'now'

/** Published versions of the brief, and what differs between two of them. */
export function BriefVersionsPage() {
  useTitle('Versions of the brief')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/brief/versions' })
  const { from, to } = useSearch({ from: '/shell/projects/$projectId/brief/versions' })
  const navigate = useNavigate()
  const list = useBriefVersions(projectId)
  const { data, error } = list
  const versions = data?.pages.flatMap(({ items }) => items)
  const newest = versions?.[0]?.number
  const first = from ?? newest ?? 0
  const compared = useQuery({ ...comparisonQuery(projectId, first, to), enabled: versions !== undefined && first > 0 })
  const choose = (search: { from?: number; to?: number }) =>
    void navigate({ to: '/projects/$projectId/brief/versions', params: { projectId }, search, replace: true })
  const numberOf = (value: string) => (value === NOW ? undefined : Number(value))
  return (
    <div className="page stack" aria-busy={!versions && error === null}>
      <div>
        <h1>Versions of the brief</h1>
        <Link className="link" to="/projects/$projectId/brief" params={{ projectId }} search={{}}>
          Back to the brief
        </Link>
      </div>
      <Refusal error={error} />
      {versions?.length === 0 && (
        <EmptyState head="No version is published yet">
          A version keeps the answers as they are, so that both sides can name what they agreed on. Publish one on the
          page of the brief.
        </EmptyState>
      )}
      {versions && versions.length > 0 && (
        <>
          <Card aria-labelledby="differences">
            <CardHead id="differences" title="What differs" count={compared.data?.differences.length} />
            <div className="row wrap p-3-inset">
              <Select
                label="From"
                value={String(first)}
                onChange={({ currentTarget }) => choose({ from: numberOf(currentTarget.value), to })}
              >
                {versions.map(({ number }) => (
                  <option key={number} value={number}>{`Version ${number}`}</option>
                ))}
              </Select>
              <Select
                label="To"
                value={to === undefined ? NOW : String(to)}
                onChange={({ currentTarget }) => choose({ from: first, to: numberOf(currentTarget.value) })}
              >
                <option value={NOW}>The brief as it is now</option>
                {versions.map(({ number }) => (
                  <option key={number} value={number}>{`Version ${number}`}</option>
                ))}
              </Select>
            </div>
            <Refusal error={compared.error} />
            {compared.data?.differences.length === 0 && <p className="p-3-inset">No answer differs.</p>}
            {compared.data?.differences.map(({ question, number, text, before, after }) => (
              <div key={question} className="border-t p-3-inset">
                <h3>{`${number}. ${text}`}</h3>
                <div className="grid gap-4 wrap-anywhere grid-cols-1fr-1fr pre-line narrow-grid-cols-1">
                  <p>
                    <span className="small dim">Before</span>
                    <br />
                    <span className="struck">{before || 'Open'}</span>
                  </p>
                  <p>
                    <span className="small dim">After</span>
                    <br />
                    {after || 'Open'}
                  </p>
                </div>
              </div>
            ))}
          </Card>
          <Card aria-labelledby="versions">
            <CardHead id="versions" title="Versions" />
            <ul className={classes.versions}>
              {versions.map(({ number, note, publisher, published_at: at, answered, total }) => (
                <li key={number} className="row wrap">
                  <span className="strong">{`Version ${number}`}</span>
                  <span className="mid">{`${shortDay(at)}, ${publisher.name}`}</span>
                  <span className="mid">{`${answered} of ${total} answered`}</span>
                  {note !== '' && <span>{note}</span>}
                </li>
              ))}
            </ul>
            <ShowMore list={list}>Older versions</ShowMore>
          </Card>
        </>
      )}
    </div>
  )
}
