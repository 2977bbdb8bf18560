import { Select, Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { contractQuery } from '@/api/project'
import { DraftForm } from '@/app/drafts/DraftForm'
import { ReasonForm } from '@/app/ReasonForm'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { planQuery } from '@/money/api'
import { conceptWords, money } from '@/money/words'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { clock, day, plural } from '@/ui/format'
import { PageWait } from '@/ui/PageWait'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Contract, useContractAction, useKeepAsTemplate, versionsQuery } from './api'
import classes from './Contracts.module.css'
import { isOrder } from './questions'
import { JointCard } from './JointCard'
import { MastersCard } from './MastersCard'
import { OffersNote } from './OffersNote'
import { RedlinesNote } from './RedlinesNote'
import { SignatureTime } from './SignatureTime'
import { Signers } from './Signers'
import { SendVersion } from './SendVersion'
import { DrawnName } from './DrawnName'
import { SignForm } from './SignForm'
import { Text } from './Text'
import { KIND_WORDS, PROOF_WORDS, progress } from './words'

/** One contract: its text, who has said yes, and what the reader may do about it. */
export function ContractPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId' })
  const { data: contract, error } = useQuery(contractQuery(contractId))
  useTitle(contract?.title ?? 'Contract')
  if (!contract) {
    return <PageWait title="Contract" error={error} />
  }
  const { kind, text } = progress(contract)
  return (
    <div className="page stack">
      <div className="flex wrap items-start between gap-2-4">
        <div>
          <h1>{contract.title}</h1>
          <p className="mid">
            {`${KIND_WORDS[contract.kind]} between ${contract.studio_name} and ${contract.designer.name}, version ${contract.version.number}`}
          </p>
          <SignatureTime contract={contract} />
        </div>
        <StatusBadge kind={kind} pill>
          {text}
        </StatusBadge>
      </div>
      {contract.change_requested && (
        <blockquote className={`m-0 p-3-4 ${classes.asked}`}>
          <p>{contract.change_requested.text}</p>
          <footer className="small mid">
            {`${contract.change_requested.by} asks for this change${contract.change_requested.clause ? ` of ${clauseTitle(contract, contract.change_requested.clause)}` : ''}, ${day(contract.change_requested.at)}`}
          </footer>
        </blockquote>
      )}
      <RedlinesNote contract={contract} to={`/projects/${projectId}/contracts/${contract.id}/redlines`} />
      <OffersNote contract={contract} to={`/projects/${projectId}/contracts/${contract.id}/changes`} />
      <div className={`columns ${classes.columns}`}>
        <Card aria-label="Text" className={classes.sheet}>
          <Text blocks={contract.version.blocks} />
          <p className={`mono dim ${classes.hash}`}>{`SHA-256 ${contract.version.text_sha256}`}</p>
        </Card>
        <div className="stack">
          <Steps contract={contract} projectId={projectId} />
          {isOrder(contract) && contract.agreed_at !== null && (
            <ButtonLink component={Link} to={`/projects/${projectId}/money`}>
              Milestones, invoices and ledger
            </ButtonLink>
          )}
          {contract.kind !== 'nda' && contract.agreed_at !== null && <MastersCard contract={contract} />}
          <JointCard contract={contract} />
          <Signers contract={contract} />
          <Said contract={contract} />
          <Versions contract={contract} projectId={projectId} />
          {contract.my_party === 'studio' && <KeepAsTemplate contract={contract} />}
          {isOrder(contract) && contract.agreed_at !== null && (
            <div className={classes.buttons}>
              <ButtonLink component={Link} icon="pencil" to={`/projects/${projectId}/contracts/${contract.id}/changes`}>
                Change orders
              </ButtonLink>
              <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contract.id}/ending`}>
                {contract.state === 'ended' ? 'Settlement' : 'Terminate contract'}
              </ButtonLink>
            </div>
          )}
          {contract.may.end && <End contract={contract} />}
        </div>
      </div>
    </div>
  )
}

const clauseTitle = (contract: Contract, key: string): string =>
  contract.version.clauses.find((clause) => clause.key === key)?.title ?? key

function Steps({ contract, projectId }: { contract: Contract; projectId: string }) {
  const { may } = contract
  if (!(may.change || may.accept || may.recall || may.request_change)) return null
  return (
    <Card aria-labelledby="next">
      <CardHead id="next" title="Next step" />
      <div className={classes.form}>
        {may.change && <SendIt contract={contract} projectId={projectId} />}
        {may.accept && <Accept contract={contract} />}
        {may.request_change && (
          <div className={classes.inner}>
            <p>Or change the text yourself, clause by clause. The studio answers each change.</p>
            <div className={classes.buttons}>
              <ButtonLink
                component={Link}
                icon="pencil"
                to={`/projects/${projectId}/contracts/${contract.id}/redlines`}
              >
                Propose changes
              </ButtonLink>
            </div>
          </div>
        )}
        {may.request_change && <AskChange contract={contract} />}
        {may.recall && <Recall contract={contract} />}
      </div>
    </Card>
  )
}

function SendIt({ contract, projectId }: { contract: Contract; projectId: string }) {
  const back = `/projects/${projectId}/contracts/${contract.id}`
  const unanswered = contract.redlines?.is_open ? contract.redlines.unanswered : 0
  if (unanswered > 0) {
    return (
      <>
        <p>{`Accept, refuse or counter each change that ${contract.designer.name} proposes. Then the next version can be sent.`}</p>
        <div className={classes.buttons}>
          <ButtonLink component={Link} variant="primary" to={`${back}/redlines`}>
            {`Answer ${plural(unanswered, 'change')}`}
          </ButtonLink>
        </div>
      </>
    )
  }
  return (
    <>
      <p>{`${contract.designer.name} receives the text as a PDF, with the current sound list and open questions.`}</p>
      {isOrder(contract) && <BeforeSending contract={contract} />}
      <SendVersion contract={contract} back={back}>
        {isOrder(contract) && (
          <ButtonLink component={Link} icon="lines" to={`${back}/plan`}>
            Plan milestones
          </ButtonLink>
        )}
      </SendVersion>
    </>
  )
}

/** What to look at before the text is sent: the price beside the bid, and cues that are concepts still. */
function BeforeSending({ contract }: { contract: Contract }) {
  const { data: plan } = useQuery(planQuery(contract.id))
  if (!plan) return null
  const { price, concepts, currency } = plan
  const above = price.above_bid_minor ?? 0
  return (
    <>
      {price.bid_minor !== null && above !== 0 && (
        <p className="tone-warn">
          {`The price is ${money(price.total_minor, currency)}, ${money(Math.abs(above), currency)} ${above > 0 ? 'above' : 'below'} the bid of ${money(price.bid_minor, currency)}.`}
        </p>
      )}
      {concepts.count > 0 && <p className="tone-warn">{conceptWords(concepts, currency)}</p>}
    </>
  )
}

function Accept({ contract }: { contract: Contract }) {
  const accept = useContractAction(contract.id)
  const textSha256 = contract.version.text_sha256
  return (
    <SignForm
      contractId={contract.id}
      textSha256={textSha256}
      label="Accept"
      button={`Sign version ${contract.version.number}`}
      before={[
        {
          key: `contract-change:${contract.id}`,
          says: 'You have typed a change that you have not requested. Request it, or clear it, before you sign.',
        },
        {
          key: `redlines:${contract.id}`,
          says: 'You have changes to this text that you have not sent. Send them, or discard them, before you sign.',
        },
      ]}
      onSign={(signed) => accept.mutateAsync({ does: 'accept', textSha256, ...signed })}
    >
      <p>The contract takes effect once everyone who is to sign it has signed.</p>
    </SignForm>
  )
}

function AskChange({ contract }: { contract: Contract }) {
  const ask = useContractAction(contract.id)
  return (
    <DraftForm
      className={classes.inner}
      aria-label="Request a change"
      draftKey={`contract-change:${contract.id}`}
      initialValues={{ text: '', clause: null as string | null }}
      mutation={ask}
      onSubmit={({ text, clause }, onSent) =>
        ask.mutate(
          { does: 'ask for a change', text: text.trim(), clause },
          {
            onSuccess: () => {
              onSent()
              showToast('Your change request was sent to the studio.')
            },
          },
        )
      }
    >
      <Field
        as={Select}
        optional
        name="clause"
        label="Or request a change to"
        placeholder="The whole contract"
        data={contract.version.clauses.map(({ key, title }) => ({ value: key, label: title }))}
        clearable
      />
      <Field as={Textarea} name="text" label="Requested change" rows={3} resize="vertical" maxLength={2000} />
      <Submit variant="plain" icon="back">
        Request change
      </Submit>
    </DraftForm>
  )
}

function Recall({ contract }: { contract: Contract }) {
  const take = useContractAction(contract.id)
  return (
    <ReasonForm
      label="Recall"
      draftKey={`contract-back:${contract.id}`}
      field="Recall it, reason"
      mutation={take}
      onSend={(reason, onSuccess) => take.mutate({ does: 'take back', reason }, { onSuccess })}
      className={classes.inner}
    >
      Recall
    </ReasonForm>
  )
}

function Said({ contract }: { contract: Contract }) {
  if (contract.acceptances.length === 0) return null
  return (
    <Card aria-labelledby="said">
      <CardHead id="said" title="Signed by" />
      <Rows aria-label="Signed by">
        {contract.acceptances.map(({ party, name, email, email_proof, code_entered_at, drawing, accepted_at }) => (
          <Row key={email} className={classes.row}>
            <div className="grow">
              <p>{name}</p>
              <p className="small mid">
                {`for the ${party}, ${email}, ${code_entered_at ? 'confirmed by a mailed code' : PROOF_WORDS[email_proof ?? 'none']}`}
              </p>
              {drawing !== null && <DrawnName strokes={drawing} name={name} />}
            </div>
            <span className="small dim">{`${day(accepted_at)}, ${clock(accepted_at)}`}</span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

function Versions({ contract, projectId }: { contract: Contract; projectId: string }) {
  const { data: versions, error } = useQuery(versionsQuery(contract.id))
  return (
    <Card aria-labelledby="versions">
      <CardHead id="versions" title="Versions and audit trail" />
      <Refusal error={error} />
      <Rows aria-label="Versions">
        {versions?.map(({ number, note, author, created_at, pdf_sha256 }) => (
          <Row key={number} className={classes.row}>
            <div className="grow">
              <p>{`Version ${number}${note ? `: ${note}` : ''}`}</p>
              <p className="small mid">{`${author.name}, ${day(created_at)}`}</p>
            </div>
            <ButtonLink
              variant="quiet"
              icon="download"
              href={`/v1/contracts/${contract.id}/versions/${number}/contract.docx`}
              aria-label={`Version ${number} for Word`}
            >
              Word
            </ButtonLink>
            {pdf_sha256 !== null && (
              <ButtonLink
                variant="quiet"
                icon="download"
                href={`/v1/contracts/${contract.id}/versions/${number}/contract.pdf`}
                aria-label={`Version ${number} as PDF`}
              >
                PDF
              </ButtonLink>
            )}
          </Row>
        ))}
      </Rows>
      <div className={`${classes.form} ${classes.buttons}`}>
        {(versions?.length ?? 0) > 1 && (
          <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contract.id}/compare`}>
            Compare versions
          </ButtonLink>
        )}
        <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contract.id}/record`}>
          Audit trail
        </ButtonLink>
        {contract.agreed_at !== null && (
          <ButtonLink component={Link} to="/verify">
            Verify a PDF
          </ButtonLink>
        )}
      </div>
    </Card>
  )
}

function KeepAsTemplate({ contract }: { contract: Contract }) {
  const keep = useKeepAsTemplate(contract.id)
  return (
    <Card aria-labelledby="keep">
      <CardHead id="keep" title="Save as template" />
      <Form
        className={classes.form}
        aria-label="Save as template"
        initialValues={{ name: '' }}
        mutation={keep}
        resets
        onSubmit={({ name }) =>
          keep.mutate(name.trim(), { onSuccess: (kept) => showToast(`Saved as the template ${kept.name}.`) })
        }
      >
        <Field name="name" label="Name" maxLength={120} />
        <Submit variant="plain">Save template</Submit>
      </Form>
    </Card>
  )
}

function End({ contract }: { contract: Contract }) {
  const end = useContractAction(contract.id)
  return (
    <details className={classes.end}>
      <summary>{contract.state === 'agreed' ? 'End this contract' : 'Withdraw contract'}</summary>
      <ReasonForm
        label="End"
        draftKey={`contract-end:${contract.id}`}
        field="Reason"
        mutation={end}
        onSend={(reason, onSuccess) => end.mutate({ does: 'end', reason }, { onSuccess })}
        className={classes.inner}
      >
        {`End ${contract.title}`}
      </ReasonForm>
    </details>
  )
}
