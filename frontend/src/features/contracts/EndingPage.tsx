import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { DraftForm } from '@/app/drafts/DraftForm'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { amount, money, percent } from '@/money/words'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { clock, day, dueDay, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { PageWait } from '@/ui/PageWait'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'

import { type Ending, endingQuery, type StatedCue, useEnding } from './api'
import classes from './Contracts.module.css'
import { DrawnName } from './DrawnName'
import { SignForm } from './SignForm'
import { Warning } from './Warning'

/** What a contract comes to if it ends early: a forecast, then a statement that both see, then what was settled. */
export function EndingPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/ending' })
  const { data: ending, error } = useQuery(endingQuery(contractId))
  useTitle('Terminate contract')
  if (!ending) {
    return <PageWait title="Terminate contract" error={error} />
  }
  return (
    <div className="page stack">
      <PageHead
        title={ending.state === 'settled' ? 'Settlement' : 'Terminate contract'}
        actions={
          <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contractId}`}>
            {ending.title}
          </ButtonLink>
        }
      >
        {standing(ending)}
      </PageHead>
      <div className={`columns ${classes.columns}`}>
        <Statement ending={ending} />
        <div className="stack">
          {ending.may.give_notice && <GiveNotice ending={ending} />}
          {ending.notice && <Signing ending={ending} />}
          {ending.state === 'settled' && ending.my_party === 'studio' && <Handover contractId={ending.contract_id} />}
          <Before ending={ending} />
        </div>
      </div>
    </div>
  )
}

/** "The studio gave notice …", or that nobody has. */
function standing({ notice, state, settled_at: settledAt, title, notice_days: days }: Ending): string {
  if (notice === null) {
    const how =
      days === null
        ? 'No clause lets one side end it alone; it ends when both agree to the statement.'
        : `Either side may end it with ${plural(days, 'day')} of notice, and both at any time.`
    return `Nobody has given notice of ${title}. ${how}`
  }
  const given = `The ${notice.party} gave notice on ${day(notice.given_at)}: ${notice.reason}`
  if (state === 'settled' && settledAt !== null) return `${given} · Settled ${day(settledAt)}, ${clock(settledAt)}.`
  if (notice.ends_on === null) return `${given} · It ends when both agree to the statement.`
  return `${given} · It ends after ${dueDay(notice.ends_on)}; every cue counts by its state then.`
}

const STATES: Record<StatedCue['state'], { kind: StateKind; word: string }> = {
  accepted: { kind: 'accepted', word: 'Accepted' },
  delivered: { kind: 'to_review', word: 'Delivered, in review' },
  in_work: { kind: 'checking', word: 'In work' },
  not_begun: { kind: 'to_make', word: 'Not begun' },
}

/** The states as the clause on cut cues defines them. */
const MEANINGS: Partial<Record<StatedCue['state'], string>> = {
  delivered: 'Delivered: every file of the cue conforms and is in review, or is approved.',
  in_work: 'In work: a file was delivered and one is missing, unchecked, returned, set aside or to change.',
  not_begun: 'Not begun: no file was delivered.',
}

interface Line {
  cues: StatedCue[]
  first: StatedCue
}

/** Cues of the same state, milestone, price and clause are one line. */
function linesOf(cues: readonly StatedCue[]): Line[] {
  const lines = new Map<string, Line>()
  for (const cue of cues) {
    const key = [cue.state, cue.was_cut, cue.milestone, cue.price_minor, cue.owed_minor, cue.clause].join('|')
    const line = lines.get(key)
    if (line) line.cues.push(cue)
    else lines.set(key, { cues: [cue], first: cue })
  }
  return [...lines.values()]
}

/** What the states of some cues mean, each once. */
const meaningsOf = (cues: readonly StatedCue[]): string[] => [
  ...new Set(cues.flatMap(({ state }) => MEANINGS[state] ?? [])),
]

function Statement({ ending }: { ending: Ending }) {
  const { currency, cues, figures } = ending
  const one = (minor: number) => amount(minor, currency)
  return (
    <Card aria-labelledby="statement">
      <CardHead
        id="statement"
        title={ending.state === 'forecast' ? 'Forecast' : 'Settlement statement'}
        note={`${ending.state === 'forecast' ? 'what ending today would come to' : ending.state === 'notice' ? 'as things stand now' : 'as settled'}, ${currency}`}
        end={
          ending.notice !== null && (
            <ButtonLink
              variant="quiet"
              icon="download"
              href={`/v1/contracts/${ending.contract_id}/ending/statement.pdf`}
              aria-label="Statement as PDF"
            >
              PDF
            </ButtonLink>
          )
        }
      />
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a region that scrolls is reached by keys */}
      <div className={`overflow-x-auto ${classes.statement}`} tabIndex={0} role="region" aria-label="Statement">
        <table>
          <thead className="small dim">
            <tr>
              <th scope="col">State</th>
              <th scope="col">Cues</th>
              <th scope="col" className={classes.number}>
                Price each
              </th>
              <th scope="col" className={classes.number}>
                Part
              </th>
              <th scope="col" className={classes.number}>
                Owed
              </th>
            </tr>
          </thead>
          <tbody>
            {linesOf(cues).map(({ cues: of, first }) => (
              <tr key={first.cue.id}>
                <td>
                  <StatusBadge kind={first.was_cut ? 'cut' : STATES[first.state].kind}>
                    {`${first.was_cut ? `Cut, ${STATES[first.state].word.toLowerCase()}` : STATES[first.state].word}, ${first.milestone}`}
                  </StatusBadge>
                </td>
                <td className={classes.names}>{of.map(({ cue }) => cue.name).join(', ')}</td>
                <td className={`${classes.number} ${classes.each}`}>{one(first.price_minor)}</td>
                <td className={`${classes.number} ${classes.each}`}>{percent(first.part_bp)}</td>
                <td className={classes.number}>{one(of.reduce((sum, each) => sum + each.owed_minor, 0))}</td>
              </tr>
            ))}
            <Sum
              head={plural(cues.length, 'cue')}
              note="the price of each cue, by its state"
              minor={ending.cues_minor}
              one={one}
              strong
            />
            <Sum
              head="Deposit"
              note={ending.deposit_at_end === 'stays' ? 'stays with the designer' : 'set off against the cues'}
              minor={ending.deposit_minor}
              one={one}
            />
            {ending.rounds_minor !== 0 && (
              <Sum head="Rounds" note="beyond those included" minor={ending.rounds_minor} one={one} />
            )}
            {ending.extra_minor !== 0 && (
              <Sum head="Other work" note="by change orders, and late interest" minor={ending.extra_minor} one={one} />
            )}
            {ending.days_minor !== 0 && (
              <Sum head="Days" note="worked and agreed" minor={ending.days_minor} one={one} />
            )}
            {ending.hours_minor !== 0 && (
              <Sum head="Hours" note="agreed, or logged and not refused" minor={ending.hours_minor} one={one} />
            )}
            {ending.retainer_minor !== 0 && (
              <Sum head="Retainer" note="months that have begun" minor={ending.retainer_minor} one={one} />
            )}
            <Sum head="Paid so far" note="" minor={-figures.paid_minor} one={one} />
          </tbody>
          <tfoot>
            <tr>
              <th scope="row">To pay</th>
              <td colSpan={3} className="small mid">
                {ending.state === 'settled'
                  ? 'excluding tax; due dates are on the invoices'
                  : `${one(ending.due_now_minor)} is due already; ${one(figures.due_minor - ending.due_now_minor)} by the settlement`}
              </td>
              <td className={`title ${classes.number}`}>{money(figures.due_minor, currency)}</td>
            </tr>
          </tfoot>
        </table>
      </div>
      <p className={`small mid p-2-4 ${classes.foot}`}>{meaningsOf(cues).join(' ')}</p>
      <p className={`small mid p-2-4 ${classes.foot}`}>
        {`Agreed ${money(figures.agreed_minor, currency)} = paid ${one(figures.paid_minor)} + to pay ${one(figures.due_minor)} + not owed ${one(figures.saved_minor)}`}
      </p>
      {ending.statement_sha256 !== null && (
        <p className={`mono dim ${classes.hash} p-2-4 ${classes.foot}`}>{`SHA-256 ${ending.statement_sha256}`}</p>
      )}
    </Card>
  )
}

function Sum({
  head,
  note,
  minor,
  one,
  strong = false,
}: {
  head: string
  note: string
  minor: number
  one: (minor: number) => string
  strong?: boolean
}) {
  return (
    <tr>
      <th scope="row" className={strong ? undefined : classes.plain}>
        {head}
      </th>
      <td colSpan={3} className="small mid">
        {note}
      </td>
      <td className={classes.number}>{strong ? <strong>{one(minor)}</strong> : one(minor)}</td>
    </tr>
  )
}

/** What the next designer begins with, for the studio, once the contract has ended. */
function Handover({ contractId }: { contractId: string }) {
  return (
    <Card aria-labelledby="handover">
      <CardHead id="handover" title="Handover pack" note="for the next designer" />
      <div className={classes.form}>
        <p>
          Approved masters with their hashes and sources, each cue with its state, files still to deliver, open rounds
          with their comments, open questions, palette and brief. It contains no amounts, no hours and no reason for the
          ending.
        </p>
        <div className="row wrap">
          <ButtonLink icon="download" href={`/v1/contracts/${contractId}/handover`} download>
            Download handover pack
          </ButtonLink>
        </div>
      </div>
    </Card>
  )
}

function GiveNotice({ ending }: { ending: Ending }) {
  const give = useEnding(ending.contract_id)
  const earliest = ending.earliest_ends_on
  return (
    <Card aria-labelledby="notice">
      <CardHead id="notice" title="Give notice" />
      <DraftForm
        className={classes.form}
        aria-label="Give notice"
        draftKey={`notice:${ending.contract_id}`}
        initialValues={{ reason: '', endsOn: '' }}
        mutation={give}
        onSubmit={({ reason, endsOn }, onSuccess) =>
          give.mutate({ does: 'give notice', reason: reason.trim(), endsOn: endsOn || null }, { onSuccess })
        }
      >
        <p>
          {earliest === null
            ? 'It ends once both sides agree to the statement.'
            : `It ends after the last day, ${dueDay(earliest)} at the earliest, or once both sides agree to the statement.`}
        </p>
        <Field
          name="reason"
          label="Reason"
          description="The other side reads it, and it stays in the audit trail."
          maxLength={2000}
        />
        {earliest !== null && <Field optional name="endsOn" label="Last day" type="date" min={earliest} />}
        <Submit variant="plain">Give notice</Submit>
      </DraftForm>
    </Card>
  )
}

function Signing({ ending }: { ending: Ending }) {
  const withdraw = useEnding(ending.contract_id)
  return (
    <Card aria-labelledby="signing">
      <CardHead id="signing" title="Agreed to by" note={`${ending.signed.length} of ${ending.signatures_needed}`} />
      <Rows aria-label="Agreed to by">
        {ending.signed.map(({ party, name, drawing, accepted_at: at }) => (
          <Row key={at} className={classes.row}>
            <div className="grow">
              <p>{`${name}, for the ${party}`}</p>
              {drawing !== null && <DrawnName strokes={drawing} name={name} />}
            </div>
            <span className="small dim">{`${day(at)}, ${clock(at)}`}</span>
          </Row>
        ))}
      </Rows>
      {(ending.may.agree || ending.may.withdraw) && (
        <div className={classes.form}>
          {ending.may.agree && <Agree ending={ending} />}
          {ending.may.withdraw && (
            <>
              <Refusal error={withdraw.error} />
              <Button aria-busy={withdraw.isPending} onClick={() => withdraw.mutate({ does: 'withdraw' })}>
                Withdraw the notice
              </Button>
            </>
          )}
        </div>
      )}
    </Card>
  )
}

function Agree({ ending }: { ending: Ending }) {
  const agree = useEnding(ending.contract_id)
  const textSha256 = ending.statement_sha256
  if (textSha256 === null) return null
  return (
    <SignForm
      contractId={ending.contract_id}
      textSha256={textSha256}
      label="Agree to the statement"
      button="Agree to the statement"
      onSign={async (signed) => {
        const { state } = await agree.mutateAsync({ does: 'agree', textSha256, ...signed })
        if (state === 'settled') showToast('Settled. The contract has ended.')
      }}
    >
      <p>The contract ends when both parties have agreed.</p>
    </SignForm>
  )
}

/** What is worth knowing before one agrees. */
function Before({ ending }: { ending: Ending }) {
  const waiting = ending.cues.filter(({ state, was_cut: cut }) => state === 'delivered' && !cut)
  if (ending.state === 'settled' || (waiting.length === 0 && ending.open_points.length === 0)) return null
  const more = waiting.reduce((sum, cue) => sum + cue.price_minor - cue.owed_minor, 0)
  const { project_id: projectId, currency } = ending
  return (
    <Card aria-labelledby="before">
      <CardHead id="before" title="Before you sign" />
      <Rows aria-label="Before you sign">
        {waiting.length > 0 && (
          <Row className={classes.row}>
            <Warning>
              {`${plural(waiting.length, 'cue waits', 'cues wait')} for approval. Accepted, they owe ${amount(more, currency)} more.`}
            </Warning>
          </Row>
        )}
        {ending.open_points.map(({ kind, text, amount_minor: minor }) => (
          <Row key={`${kind} ${text}`} className={classes.row}>
            <Warning>{`Not counted until the studio agrees: ${text}, ${amount(minor, currency)}`}</Warning>
          </Row>
        ))}
      </Rows>
      {ending.open_points.length > 0 && (
        <div className={`${classes.form} ${classes.buttons}`}>
          <ButtonLink component={Link} to={`/projects/${projectId}/money`}>
            Review open charges
          </ButtonLink>
        </div>
      )}
    </Card>
  )
}
