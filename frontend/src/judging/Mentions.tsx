import { lazy, type RefObject, Suspense } from 'react'

const MentionList = lazy(async () => ({ default: (await import('./MentionList')).MentionList }))

export interface MentionsProps {
  takeId: string
  field: RefObject<HTMLInputElement | HTMLTextAreaElement | null>
  text: string
  onText: (text: string) => void
}

/** Offers people below a field in which an @ is typed; loaded with the first @. */
export function Mentions(props: MentionsProps) {
  if (!props.text.includes('@')) return null
  return (
    <Suspense fallback={null}>
      <MentionList {...props} />
    </Suspense>
  )
}
