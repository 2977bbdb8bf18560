import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { PageHead } from '@/ui/PageHead'

import { TokensCard } from './Tokens'

/** The tokens with which the game's CI reads the list and reports its builds. */
export function TokensPage() {
  useTitle('Tokens')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/tokens' })
  const { data: project } = useQuery(projectQuery(projectId))
  return (
    <div className="page page-narrow stack">
      <PageHead title="Tokens">For the CI of the game and for programs of your own.</PageHead>
      {project?.mine.is_producer === false && <p>Only producers make tokens.</p>}
      {project?.mine.is_producer && <TokensCard projectId={projectId} />}
    </div>
  )
}
