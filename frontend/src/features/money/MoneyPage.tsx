import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { useIsParty, useMyProject } from '@/api/me'
import { useTitle } from '@/app/title'
import { moneyQuery, type ContractMoney } from '@/money/api'
import { MilestonesCard } from '@/money/MilestonesCard'
import { MoneyLine } from '@/money/MoneyLine'
import { OwnTimeCard } from '@/money/OwnTimeCard'
import { ButtonLink } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import { BonusCard } from './BonusCard'
import { DaysCard } from './DaysCard'
import { EstimatesCard } from './EstimatesCard'
import { HoursCard } from './HoursCard'
import { InvoicesCard } from './InvoicesCard'
import { LedgerCard } from './LedgerCard'
import { RoundsCard } from './RoundsCard'

/** What was agreed in a project, what is due and paid, and every line that says why. */
export function MoneyPage() {
  useTitle('Money')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/money' })
  const project = useMyProject(projectId)
  const mayLook = useIsParty(projectId)
  const { data, error } = useQuery({ ...moneyQuery(projectId), enabled: mayLook })
  const side = project?.part === 'designer' ? 'designer' : 'team'
  return (
    <div className="page">
      <PageHead
        title="Money"
        actions={
          data &&
          data.contracts.length > 0 && (
            <ButtonLink icon="download" href={`/v1/projects/${projectId}/journal.csv`} download>
              Journal (CSV)
            </ButtonLink>
          )
        }
      >
        {data &&
          data.contracts.length > 0 &&
          `${side === 'designer' ? 'You are paid' : 'You pay'} for accepted cues and the deposit. Each entry shows its cue, its clause and who triggered it.`}
      </PageHead>
      <Refusal error={error} />
      {project && !mayLook && (
        <EmptyState head="You don’t have access to money in this project">
          Only producers, audio leads and the designers concerned can see contracts’ amounts.
        </EmptyState>
      )}
      {data?.contracts.length === 0 && (
        <EmptyState
          head="No signed contract yet"
          action={
            <Link className="link" to="/projects/$projectId/contracts" params={{ projectId }}>
              Go to contracts
            </Link>
          }
        >
          {side === 'team'
            ? 'Sounds can be made and accepted without a contract. Once one is signed, its milestones, invoices and payments appear here.'
            : 'Once you and the studio have signed a contract, you see here what you are owed and what was paid.'}
        </EmptyState>
      )}
      <div className="stack">
        {data?.totals.map(({ currency, figures }) => (
          <MoneyLine key={currency} currency={currency} figures={figures} side={side} />
        ))}
        {data?.contracts.map((contract) => (
          <Contract
            key={contract.contract_id}
            contract={contract}
            projectId={projectId}
            side={side}
            isProducer={project?.is_producer ?? false}
          />
        ))}
        {side === 'designer' && project && <OwnTimeCard projectId={projectId} />}
      </div>
    </div>
  )
}

interface ContractProps {
  contract: ContractMoney
  projectId: string
  side: 'team' | 'designer'
  isProducer: boolean
}

function Contract({ contract, projectId, side, isProducer }: ContractProps) {
  const grows = contract.slip_growth_days ?? 0
  return (
    <section className="columns" aria-label={`${contract.title}, ${contract.designer.name}`}>
      <div className="stack">
        <DaysCard contract={contract} side={side} isProducer={isProducer} />
        <HoursCard contract={contract} projectId={projectId} side={side} isProducer={isProducer} />
        <InvoicesCard contract={contract} side={side} isProducer={isProducer} />
        <LedgerCard contractId={contract.contract_id} title={contract.title} />
      </div>
      <aside className="stack" aria-label={`More about ${contract.title}`}>
        <MilestonesCard
          contracts={[contract]}
          side={side}
          projectId={projectId}
          of={contract.title}
          end={`${contract.title}, ${contract.designer.name}`}
        />
        <BonusCard contract={contract} isProducer={isProducer} />
        {grows > 0 && <p className="small mid">Each milestone is {grows.toFixed(1)} days later than the one before.</p>}
        <RoundsCard rounds={contract.proposed_rounds} title={contract.title} side={side} isProducer={isProducer} />
        {(isProducer || side === 'designer') && (
          <EstimatesCard contractId={contract.contract_id} title={contract.title} />
        )}
      </aside>
    </section>
  )
}
