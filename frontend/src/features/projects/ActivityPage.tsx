import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'

import { overviewQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { Refusal } from '@/ui/Refusal'
import { PageSkeleton } from '@/ui/Skeleton'

import { RecentActivityCard } from './RecentActivityCard'

/** The last events of a project, the newest first. */
export function ActivityPage() {
  useTitle('Activity')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/activity' })
  const { data: overview, error } = useQuery(overviewQuery(projectId))
  if (overview === undefined && error === null) return <PageSkeleton />
  return (
    <div className="page page-narrow stack">
      <h1>Activity</h1>
      <Refusal inset error={error} />
      {overview && <RecentActivityCard projectId={projectId} happened={overview.lately} />}
    </div>
  )
}
