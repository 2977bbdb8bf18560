import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { money } from '@/money/words'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { PageHead } from '@/ui/PageHead'

import { AwardDialog } from './AwardDialog'
import { BidNotesCard } from './BidNotesCard'
import { BidsTable } from './BidsTable'
import { type ComparedBid, type Comparison, comparisonQuery, useShortlist } from './api'
import { ScoreCard } from './ScoreCard'
import { useSamplePlayer } from './player'
import { matchingSampleOfNextBid } from './samples'
import { period } from './words'

const GROUP = 'Bids'
const FROM = '/shell/projects/$projectId/postings/$postingId/bids'

/** The bids of a posting side by side on the same lines, with the team's scores, and the award. */
export function BidsPage() {
  const { projectId, postingId } = useParams({ from: FROM })
  const { data, error } = useQuery(comparisonQuery(postingId))
  useTitle(data ? `Bids on ${data.title}` : 'Bids')
  return (
    <div className="page stack" aria-busy={!data && error === null}>
      {error && <h1>Bids</h1>}
      <Refusal error={error} />
      {data && <Compared comparison={data} projectId={projectId} />}
    </div>
  )
}

function Compared({ comparison, projectId }: { comparison: Comparison; projectId: string }) {
  const { posting_id: postingId, bids, title, currency, budget_minor: budget, pending } = comparison
  const [chosenId, setChosen] = useState<string | null>(null)
  const [awarding, setAwarding] = useState<ComparedBid | null>(null)
  const chosen = bids.find(({ id }) => id === chosenId) ?? bids[0]
  const shortlist = useShortlist(postingId)
  const scores = useRef<HTMLDivElement>(null)
  const toScores = () => scores.current?.querySelector<HTMLElement>('select')?.focus()
  const mark = (bid: ComparedBid) => {
    setChosen(bid.id)
    shortlist.mutate({ id: bid.id, on: !bid.is_shortlisted })
  }
  const player = useSamplePlayer()
  const hasSamples = bids.some(({ samples }) => samples.some((sample) => sample.is_open))
  const playSame = () => {
    const next = matchingSampleOfNextBid(bids, player.playingId)
    if (next === null) return
    setChosen(next.bid.id)
    player.compare(next.id)
  }
  useHotkeys([
    { keys: 'b', label: 'Same sample of the next bid', group: GROUP, run: playSame, disabled: !hasSamples },
    ...bids.slice(0, 9).map((bid, at) => ({
      keys: String(at + 1),
      label: `Bid ${at + 1}`,
      group: GROUP,
      unlisted: at > 0,
      run: () => setChosen(bid.id),
    })),
    { keys: 's', label: 'Score', group: GROUP, run: toScores, disabled: !chosen },
    { keys: 'l', label: 'Shortlist', group: GROUP, run: () => chosen && mark(chosen), disabled: !chosen },
    {
      keys: 'shift+Enter',
      label: 'Award, after a question',
      group: GROUP,
      run: () => setAwarding(chosen ?? null),
      disabled: !comparison.may_award || !chosen,
    },
  ])
  return (
    <>
      <PageHead title={`${plural(bids.length, 'bid')} on ${title}`}>
        {budget === null ? '' : `Budget ${money(budget, currency)}. `}
        {`Work: ${period(comparison.work_from_on, comparison.work_to_on)}. `}
        {pending.length > 0 && `No bid yet from ${pending.join(', ')}. `}
        <Link className="link" to="/projects/$projectId/postings/$postingId" params={{ projectId, postingId }}>
          The posting
        </Link>
        {comparison.contract_id && (
          <>
            {' · '}
            <Link
              className="link"
              to="/projects/$projectId/contracts/$contractId/draft"
              params={{ projectId, contractId: comparison.contract_id }}
            >
              The draft contract
            </Link>
          </>
        )}
      </PageHead>
      <Refusal error={shortlist.error} />
      {chosen === undefined ? (
        <EmptyState head="No bid yet">
          {pending.length > 0
            ? `Asked: ${pending.join(', ')}.`
            : 'Nobody has been asked yet. Ask designers on the posting.'}
        </EmptyState>
      ) : (
        <>
          <KeysLine
            keys={[
              { keys: ['1'], label: 'bid' },
              { keys: ['s'], label: 'score' },
              { keys: ['l'], label: 'shortlist' },
              ...(hasSamples ? [{ keys: ['b'], label: 'same sample of the next bid' }] : []),
              { keys: ['shift+Enter'], label: 'award' },
            ]}
          />
          <BidsTable
            comparison={comparison}
            chosenId={chosen.id}
            player={player}
            onMark={mark}
            onAward={(bid) => {
              setChosen(bid.id)
              setAwarding(bid)
            }}
          />
          <div ref={scores} className="stack">
            <ScoreCard key={chosen.id} comparison={comparison} bid={chosen} />
            <BidNotesCard key={`notes-${chosen.id}`} comparison={comparison} bid={chosen} />
          </div>
        </>
      )}
      {awarding && (
        <AwardDialog comparison={comparison} bid={awarding} projectId={projectId} onClose={() => setAwarding(null)} />
      )}
    </>
  )
}
