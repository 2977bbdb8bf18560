import { useQuery } from '@tanstack/react-query'
import { useNavigate, useSearch } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { Segmented } from '@/ui/Segmented'
import { PageSkeleton } from '@/ui/Skeleton'

import { operationsQuery, type Scope } from './api'
import { JobsCard } from './JobsCard'
import { LimitsCard } from './LimitsCard'
import { LanesCard, StorageCard, WorkersCard } from './SideCards'
import { inOneLine } from './words'

const SERVER = 'server'

/** What waits, runs and gave up, what is kept, and who works: of a studio, or of the whole server. */
export function OperationsPage() {
  useTitle('Jobs and storage')
  const { data: me } = useQuery(meQuery)
  const { of }: { of?: string } = useSearch({ strict: false })
  const navigate = useNavigate()
  if (me === undefined) return <PageSkeleton />
  const views = [
    ...(me.is_operator ? [{ value: SERVER, label: 'Whole server' }] : []),
    ...me.studios.filter(({ roles }) => roles.includes('producer')).map(({ id, name }) => ({ value: id, label: name })),
  ]
  const view = views.find(({ value }) => value === of) ?? views[0]
  if (view === undefined) {
    return (
      <div className="page">
        <EmptyState level={1} head="Only producers can see jobs and storage">
          Producers see their studio’s jobs. The server’s operators see all.
        </EmptyState>
      </div>
    )
  }
  const scope: Scope = view.value === SERVER ? SERVER : { studioId: view.value }
  return (
    <div className="page">
      <header className="flex wrap items-end between gap-2-4 mb-4">
        <div>
          <h1>Jobs and storage</h1>
          <InOneLine scope={scope} />
        </div>
        {views.length > 1 && (
          <Segmented
            label="Scope"
            options={views}
            value={view.value}
            onChange={(value) => void navigate({ to: '/operations', search: { of: value }, replace: true })}
          />
        )}
      </header>
      <div className="columns">
        <JobsCard key={view.value} scope={scope} />
        <div className="stack">
          <LanesCard scope={scope} />
          <WorkersCard scope={scope} />
          <StorageCard scope={scope} />
          <LimitsCard scope={scope} />
        </div>
      </div>
    </div>
  )
}

function InOneLine({ scope }: { scope: Scope }) {
  const { data, error } = useQuery(operationsQuery(scope))
  if (error) return <Refusal error={error} />
  return <p className="mid">{data ? inOneLine(data.counts, data.alive) : 'Loading…'}</p>
}
