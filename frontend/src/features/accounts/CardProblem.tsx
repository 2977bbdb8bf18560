import { Refusal } from '@/ui/Refusal'

/** A refusal of something that was pressed in a card, said in the card. */
export function CardProblem({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  return (
    <div className="border-b p-3-inset">
      <Refusal error={error} />
    </div>
  )
}
