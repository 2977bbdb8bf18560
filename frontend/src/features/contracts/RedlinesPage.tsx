import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { contractQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

import { ProposeRedlines } from './ProposeRedlines'
import { RedlineRound } from './RedlineRound'
import { redlinesQuery } from './redlines'

/** What the designer wants otherwise in a text, clause by clause, and what the studio answered. */
export function RedlinesPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/redlines' })
  const [chosen, setChosen] = useState<number>()
  const { data: contract, error } = useQuery(contractQuery(contractId))
  const { data: redlines, error: unread } = useQuery(redlinesQuery(contractId, chosen))
  useTitle('Redlines')
  const refused = error ?? unread
  const back = `/projects/${projectId}/contracts/${contractId}`
  return (
    <div className="page stack" aria-busy={(!contract || !redlines) && !refused}>
      <div className="flex wrap items-start between gap-2-4">
        <div>
          <h1>Redlines</h1>
          {contract && (
            <p className="mid">{`of ${contract.title}. What is signed is the text as both have agreed it.`}</p>
          )}
        </div>
        <ButtonLink component={Link} to={back}>
          Back to contract
        </ButtonLink>
      </div>
      <Refusal error={refused} />
      {redlines && redlines.rounds > 1 && (
        <div>
          <Select
            label="Round"
            value={chosen ?? redlines.rounds}
            onChange={({ currentTarget }) => setChosen(Number(currentTarget.value))}
          >
            {Array.from({ length: redlines.rounds }, (_, index) => index + 1).map((number) => (
              <option key={number} value={number}>{`Round ${number}`}</option>
            ))}
          </Select>
        </div>
      )}
      {contract && redlines?.round && (
        <RedlineRound
          key={redlines.round.number}
          contract={contract}
          round={redlines.round}
          mayAnswer={redlines.may_answer}
          back={back}
        />
      )}
      {contract?.may.request_change && <ProposeRedlines contract={contract} />}
      {contract && redlines?.round === null && !contract.may.request_change && (
        <EmptyState head="No redlines yet">
          The designer proposes changes of the text, clause by clause, while the contract needs their signature.
        </EmptyState>
      )}
    </div>
  )
}
