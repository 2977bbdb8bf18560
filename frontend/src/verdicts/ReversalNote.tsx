import { useQuery } from '@tanstack/react-query'

import { cueMoneyQuery } from '@/money/api'
import { money } from '@/money/words'

interface ReversalNoteProps {
  cueId: string
  /** What is approved: "shield_hit A". */
  what: string
}

/** What a change request for an approved version takes back, said before it is sent. */
export function ReversalNote({ cueId, what }: ReversalNoteProps) {
  const { data: due } = useQuery(cueMoneyQuery(cueId))
  const taken = due ? due.would_take_back_minor : 0
  return (
    <p className="small tone-warn toned">
      {what} is approved. Sending this change takes the approval back
      {due && taken > 0 && `, and ${money(taken, due.currency)} is no longer due`}.
    </p>
  )
}
