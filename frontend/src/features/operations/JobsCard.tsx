import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FilterChip } from '@/ui/FilterChip'
import { Refusal } from '@/ui/Refusal'
import { ago, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { ShowMore } from '@/ui/ShowMore'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Job, jobsQuery, type JobState, operationsQuery, type Scope, useRetry } from './api'
import classes from './Operations.module.css'
import { jobsIn, jobWords, SERVER_ITSELF, STATE_FACES, STATES_SHOWN } from './words'

/** The jobs that are not done, the oldest first; one that gave up can be tried again. */
export function JobsCard({ scope }: { scope: Scope }) {
  const [state, setState] = useState<JobState | undefined>(undefined)
  const { data: sums } = useQuery(operationsQuery(scope))
  const jobs = useInfiniteQuery(jobsQuery(scope, state))
  const retry = useRetry(scope)
  const counts = sums?.counts ?? []
  const all = STATES_SHOWN.reduce((sum, option) => sum + jobsIn(counts, option), 0)
  const rows = jobs.data?.pages.flatMap(({ items }) => items) ?? []
  const again = (job: Job) =>
    retry.mutate(job.id, { onSuccess: () => showToast(`${jobWords(job.job)} is queued again.`) })
  return (
    <Card aria-labelledby="jobs">
      <CardHead id="jobs" title="Jobs" count={all} note="finished jobs are not listed" />
      <div role="group" aria-label="Filter by state" className="flex gap-2 border-b overflow-x-auto p-3-inset">
        <FilterChip count={all} pressed={state === undefined} onPress={() => setState(undefined)}>
          All
        </FilterChip>
        {STATES_SHOWN.filter((option) => option !== 'broken' || jobsIn(counts, option) > 0).map((option) => (
          <FilterChip
            key={option}
            kind={STATE_FACES[option].kind}
            count={jobsIn(counts, option)}
            pressed={state === option}
            onPress={() => setState(option)}
          >
            {STATE_FACES[option].word}
          </FilterChip>
        ))}
      </div>
      {(jobs.error ?? retry.error) && (
        <div className="p-inset">
          <Refusal error={retry.error ?? jobs.error} />
        </div>
      )}
      {jobs.isSuccess && rows.length === 0 && (
        <div className="p-inset">
          <EmptyState head={state === 'parked' ? 'No failed jobs' : 'No jobs'} level={3}>
            Deliveries, changes and approvals create jobs. They normally finish within seconds.
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Jobs">
        {rows.map((job) => (
          <JobRow key={job.id} job={job} scope={scope} busy={retry.isPending} onRetry={() => again(job)} />
        ))}
      </Rows>
      {jobs.hasNextPage && (
        <div className="p-inset">
          <ShowMore list={jobs} />
        </div>
      )}
    </Card>
  )
}

function JobRow({ job, scope, busy, onRetry }: { job: Job; scope: Scope; busy: boolean; onRetry: () => void }) {
  const { kind, word } = STATE_FACES[job.state]
  const whose = scope === 'server' ? (job.studio_name ?? SERVER_ITSELF) : null
  return (
    <Row className={classes.job}>
      <span className="grow">
        <span className="strong">{jobWords(job.job)}</span>
        {whose !== null && <span className="mid"> {whose}</span>}
        <br />
        <span className="small dim">
          queued {ago(job.since)}
          {job.tries > 0 && `, ${plural(job.tries, 'try', 'tries')}`}
        </span>
        {job.reason !== null && <span className="small block wrap-anywhere font-mono">{job.reason}</span>}
      </span>
      <StatusBadge kind={kind}>{word}</StatusBadge>
      {job.state === 'parked' && (
        <Button aria-label={`Try again: ${jobWords(job.job)}`} disabled={busy} onClick={onRetry}>
          Try again
        </Button>
      )}
    </Row>
  )
}
