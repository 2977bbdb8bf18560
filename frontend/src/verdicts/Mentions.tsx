import { lazy, Suspense } from 'react'

import type { MentionsProps } from './mentionNames'

const MentionList = lazy(async () => ({ default: (await import('./MentionList')).MentionList }))

/** Offers people below a field in which an @ is typed; loaded with the first @. */
export function Mentions(props: MentionsProps) {
  if (!props.text.includes('@')) return null
  return (
    <Suspense fallback={null}>
      <MentionList {...props} />
    </Suspense>
  )
}
