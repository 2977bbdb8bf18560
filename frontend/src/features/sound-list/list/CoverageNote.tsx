import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { coverageQuery } from '@/api/project'
import { Icon } from '@/ui/Icon'

import classes from './SoundList.module.css'

/** "a, b, c and 4 more" */
function few(names: readonly string[]): string {
  const shown = names.slice(0, 3).join(', ')
  return names.length > 3 ? `${shown} and ${names.length - 3} more` : shown
}

/** What the brief names and no cue is for, or a wish alone. */
export function CoverageNote({ projectId }: { projectId: string }): ReactNode {
  const { data } = useQuery(coverageQuery(projectId))
  if (!data) return null
  const missing = [
    ['No ambience for', data.scenes_without_ambience],
    ['No cue in', data.categories_without_cue],
    ['No cue for', data.priority_without_cue],
    ['Only a wish for', data.priority_as_wish],
  ] as const
  const gaps = missing.filter(([, names]) => names.length > 0)
  if (gaps.length === 0) return null
  return (
    <p className={`row wrap ${classes.coverage}`}>
      <span className="tone-warn toned">
        <Icon name="triangle" />
      </span>
      <span>
        {gaps.map(([words, names]) => `${words} ${few(names)}`).join('. ')}
        {', which '}
        <Link className="link" to={`/projects/${projectId}/brief` as LinkProps['to']}>
          the brief
        </Link>
        {' names.'}
      </span>
    </p>
  )
}
