import { ProblemNote } from '@/ui/ProblemNote'

import { refusal } from './words'

/** What the server refused, where it was asked. */
export function Refusal({ error }: { error: unknown }) {
  const said = refusal(error)
  return said === null ? null : <ProblemNote {...said} />
}
