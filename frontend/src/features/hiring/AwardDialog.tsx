import { useQuery } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'

import { Dialog } from '@/app/Dialog'
import { showToast } from '@/app/toast'
import { mailedLinksQuery } from '@/mails'
import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { type ComparedBid, type Comparison, useAward } from './api'

interface AwardDialogProps {
  comparison: Comparison
  bid: ComparedBid
  projectId: string
  onClose: () => void
}

/** Names who gets which email, before anything happens. */
export function AwardDialog({ comparison, bid, projectId, onClose }: AwardDialogProps) {
  const award = useAward(comparison.posting_id)
  const navigate = useNavigate()
  const { data: mails } = useQuery(mailedLinksQuery(projectId))
  const sendsMail = mails?.can_send !== false
  const isLeftOut = comparison.is_roster_full && bid.roster_entry_id === null
  const others = comparison.bids.filter(({ id }) => id !== bid.id).map(({ designer }) => designer.name)
  const send = () => {
    if (award.isPending) return
    award.mutate(bid.id, {
      onSuccess: ({ contract_id: contractId, is_on_roster: isOnRoster }) => {
        if (!isOnRoster) showToast(`Awarded. Your roster is full, so ${bid.designer.name} is not on it.`)
        void navigate({ to: '/projects/$projectId/contracts/$contractId/draft', params: { projectId, contractId } })
      },
    })
  }
  return (
    <Dialog title={`Award ${comparison.title} to ${bid.designer.name}?`} opened onClose={onClose}>
      <div className="grid gap-3">
        <p>{`${bid.designer.name} gets ${sendsMail ? 'an email' : 'a notice here'} that the bid was chosen, and joins the project${isLeftOut ? '' : ' and your roster'}.`}</p>
        {isLeftOut && (
          <p className="tone-warn">
            <span className="toned">{`Your roster is full: ${bid.designer.name} is not added to it.`}</span>
          </p>
        )}
        {others.length > 0 && (
          <p>{`${others.join(', ')}: thanked${sendsMail ? ' by email' : ''}, and informed that another bid was chosen.`}</p>
        )}
        <p>{`A draft contract over ${money(bid.total_minor, comparison.currency)} opens. Nothing is signed.`}</p>
        {!sendsMail && <p className="mid">This server sends no email: everyone reads it in Soundlist.</p>}
        {bid.missing.length > 0 && (
          <p className="tone-warn">
            <span className="toned">{`This bid is without ${bid.missing.join(', ')}.`}</span>
          </p>
        )}
        <Refusal error={award.error} />
        <div className="row">
          <Button data-autofocus onClick={onClose}>
            Not yet
          </Button>
          <Button variant="primary" aria-busy={award.isPending} onClick={send}>
            Award
          </Button>
        </div>
      </div>
    </Dialog>
  )
}
