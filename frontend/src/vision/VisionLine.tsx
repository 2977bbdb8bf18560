import { queryOptions, useQuery } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'

import classes from './Vision.module.css'

const visionQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.brief(projectId, 'vision'),
    queryFn: () => get('/v1/projects/{project_id}/vision', { project_id: projectId }),
  })

/** How the game should feel to the ear, as the brief says it: one line, which opens; on a phone it is folded. */
export function VisionLine({ projectId }: { projectId: string }) {
  const { data: vision } = useQuery(visionQuery(projectId))
  if (!vision?.text) return null
  return (
    <details className={`small dim ${classes.vision}`}>
      <summary>
        Vision<span className={classes.line}>: {vision.text}</span>
      </summary>
      <p className="mid">{vision.text}</p>
    </details>
  )
}
