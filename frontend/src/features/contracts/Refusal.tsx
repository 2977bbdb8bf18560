import { ProblemNote } from '@/ui/ProblemNote'

import { refusal } from './words'

/** What the server refused, where it was asked. */
export function Refusal({ error }: { error: unknown }) {
  return error === null || error === undefined ? null : <ProblemNote {...refusal(error)} />
}
