import { useQuery } from '@tanstack/react-query'
import type { ReactNode } from 'react'

import { useTitle } from '@/app/title'
import { Refusal } from '@/ui/Refusal'
import { PageSkeleton } from '@/ui/Skeleton'

import { type Posting, postingQuery } from './api'
import classes from './Hiring.module.css'

type Found = { posting: Posting; missing?: undefined } | { posting?: undefined; missing: ReactNode }

/** A posting, and its title on the page; without it, what to show in its place. */
export function usePosting(postingId: string): Found {
  const { data: posting, error } = useQuery(postingQuery(postingId))
  useTitle(posting?.title ?? 'Posting')
  if (posting) return { posting } // what is here stays while the server is away
  if (error === null) return { missing: <PageSkeleton /> }
  return {
    missing: (
      <div className={`page stack ${classes.sheet}`}>
        <h1>Posting</h1>
        <Refusal error={error} />
      </div>
    ),
  }
}
