import { NativeSelect, NumberInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { useMyProject } from '@/api/me'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { milestoneQuery, type MilestoneCue, type MilestoneSheet, useLogWork } from '@/money/api'
import { amount, hours, money, slipInWords } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { average, day, deviation, dueDay, figure, plural, shortDay, today } from '@/ui/format'
import { PageWait } from '@/ui/PageWait'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'
import { Table } from '@/ui/Table'

import { LedgerTable } from './LedgerTable'
import classes from './Page.module.css'

type Side = 'team' | 'designer'

/** One milestone: its cues, how late it is and with whom the days went, its estimates, and every line of its money. */
export function MilestonePage() {
  const { projectId, milestoneId } = useParams({ from: '/shell/projects/$projectId/milestones/$milestoneId' })
  const { data: sheet, error } = useQuery(milestoneQuery(milestoneId))
  const project = useMyProject(projectId)
  useTitle(sheet?.milestone.name ?? 'Milestone')
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  if (!sheet) {
    return <PageWait title="Milestone" error={error} />
  }
  const side: Side = project?.part === 'designer' ? 'designer' : 'team'
  return (
    <div className="page">
      <Head sheet={sheet} side={side} />
      <div className="columns">
        <div className="stack">
          {sheet.blocked_by.length > 0 && <BlockedCard sheet={sheet} />}
          <CuesCard sheet={sheet} side={side} />
          <LinesCard sheet={sheet} />
        </div>
        <aside className="stack" aria-label={`More about ${sheet.milestone.name}`}>
          <DueCard sheet={sheet} side={side} />
          <SlipCard sheet={sheet} side={side} />
          <EstimateCard sheet={sheet} side={side} />
        </aside>
      </div>
    </div>
  )
}

function Head({ sheet, side }: { sheet: MilestoneSheet; side: Side }) {
  const { milestone, contract_title: title, contract_id: contractId, project_id: projectId, designer } = sheet
  const { due_on: due, done_at: done, accepted, wanted } = milestone
  return (
    <header className={`flex wrap between mb-4 ${classes.head}`}>
      <div>
        <h1>{milestone.name}</h1>
        <p className="mid">
          {milestone.is_deposit
            ? 'Due when the contract is signed.'
            : `${accepted} of ${plural(wanted, 'cue')} accepted. ${due === null ? 'No due date.' : done === null ? `Due ${dueDay(due)}.` : `Due ${shortDay(due)}, done ${day(done)}.`}`}
        </p>
        <p className="small mid">
          Of{' '}
          <Link className="link" to="/projects/$projectId/contracts/$contractId" params={{ projectId, contractId }}>
            {title}
          </Link>
          {side === 'team' ? `, with ${designer.name}. ` : '. '}
          <Link className="link" to="/projects/$projectId/money" params={{ projectId }}>
            All money in this project
          </Link>
        </p>
      </div>
      <p className="title">{money(milestone.left_minor, sheet.currency)}</p>
    </header>
  )
}

/** The open questions for which its work waits. */
function BlockedCard({ sheet: { blocked_by: questions, project_id: projectId } }: { sheet: MilestoneSheet }) {
  return (
    <Card aria-labelledby="blocked">
      <CardHead id="blocked" title="Blocked by" end={plural(questions.length, 'question')} />
      <Rows>
        {questions.map(({ id, cue, text, owner, due_on }) => (
          <Row key={id}>
            <StatusBadge kind="question" />
            <div>
              <p>{text}</p>
              <p className="small mid">
                <Link
                  className="link"
                  to="/projects/$projectId/sound-list/cues/$cueId"
                  params={{ projectId, cueId: cue.id }}
                >
                  {cue.name}
                </Link>
                {` waits for ${owner?.name ?? 'the team'}${due_on === null ? '' : `, due ${dueDay(due_on)}`}.`}
              </p>
            </div>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

const kindOf = (status: MilestoneCue['status']): StateKind => (status === 'partly_accepted' ? 'approved' : status)

function CuesCard({ sheet, side }: { sheet: MilestoneSheet; side: Side }) {
  const { cues, currency, project_id: projectId, milestone } = sheet
  return (
    <Card aria-labelledby="cues">
      <CardHead
        id="cues"
        title="Cues"
        count={cues.length}
        end={sheet.release === 'per_cue' ? 'each is paid when accepted' : 'all are paid when the last one is accepted'}
      />
      {cues.length === 0 && (
        <div className="p-3-inset">
          <EmptyState
            head={milestone.is_deposit ? 'A deposit depends on no cue' : 'No cues in this milestone'}
            level={3}
          >
            {milestone.is_deposit ? 'It is due at signing.' : 'Only accepted cues make an amount due.'}
          </EmptyState>
        </div>
      )}
      <Rows>
        {cues.map((row) => (
          <Row key={row.cue.id} className={classes.cue}>
            <span className="grow">
              <Link
                className="link"
                to="/projects/$projectId/sound-list/cues/$cueId"
                params={{ projectId, cueId: row.cue.id }}
              >
                <span className="mono dim">{row.cue.label}</span>
                <span className={`${classes.name} ${row.cut_in === null ? '' : 'struck'}`}>{row.cue.name}</span>
              </Link>
            </span>
            {side === 'team' && row.status === 'to_review' ? (
              <Link
                className="link"
                to="/projects/$projectId/review/$cueId"
                params={{ projectId, cueId: row.cue.id }}
                search={{}}
                aria-label={`Review ${row.cue.name}`}
              >
                <StatusBadge kind="to_review" />
              </Link>
            ) : (
              <StatusBadge kind={kindOf(row.status)}>
                {row.status === 'partly_accepted' ? 'Partly accepted' : undefined}
              </StatusBadge>
            )}
            <span className={`small mid num ${classes.share}`}>{shareInWords(row, currency)}</span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

/** "180.00 due", "157.50 of 315.00, cut": what a cue's share comes to. */
function shareInWords(
  { amount_minor: share, owed_minor: owed, paid_minor: paid, cut_in }: MilestoneCue,
  currency: string,
) {
  if (share === null) return 'not agreed yet'
  const whole = amount(share, currency)
  if (cut_in !== null)
    return `${amount(owed, currency)} of ${whole} for the cut${paid !== 0 && paid === owed ? ', paid' : ''}`
  if (owed === 0) return whole
  return `${owed === share ? whole : `${amount(owed, currency)} of ${whole}`} ${paid === owed ? 'paid' : 'due'}`
}

function LinesCard({ sheet }: { sheet: MilestoneSheet }) {
  const { milestone, lines, currency } = sheet
  return (
    <Card aria-labelledby="lines">
      <CardHead
        id="lines"
        title="Ledger of this milestone"
        count={lines.length}
        end="entries are added, never changed"
      />
      {lines.length === 0 ? (
        <p className="mid p-3-inset">Nothing is due yet.</p>
      ) : (
        <LedgerTable lines={lines} currency={currency} name={`Lines of ${milestone.name}`} />
      )}
    </Card>
  )
}

const INVOICE_STATES = { open: 'open', partly_paid: 'partly paid', paid: 'paid', late: 'late' }

function DueCard({ sheet, side }: { sheet: MilestoneSheet; side: Side }) {
  const { milestone, currency, invoices, project_id: projectId } = sheet
  const { owed_minor: owed, paid_minor: paid, left_minor: left } = milestone
  const saved = milestone.amount_minor - left
  const facts = [
    { name: 'Agreed', minor: milestone.amount_minor },
    { name: 'Saved by cuts', minor: saved },
    { name: 'Due so far', minor: owed },
    { name: 'Paid', minor: paid },
  ].filter(({ name, minor }) => name !== 'Saved by cuts' || minor !== 0)
  return (
    <Card aria-labelledby="due">
      <CardHead id="due" title={side === 'team' ? 'Due to the designer' : 'You are owed'} end="excluding tax" />
      <div className="p-3-inset">
        <p className="figure">{money(owed - paid, currency)}</p>
        {facts.map(({ name, minor }) => (
          <p key={name} className="small grid grid-cols-1-auto gap-0-3">
            <span className="mid">{name}</span> <span>{amount(minor, currency)}</span>
          </p>
        ))}
      </div>
      <Rows aria-label="Invoices for this milestone">
        {invoices.map(({ id, number, state, open_minor: open }) => (
          <Row key={id} dense>
            <span className="grow small">
              <a className="link" href={`/v1/invoices/${id}/invoice.pdf`} target="_blank" rel="noreferrer">
                Invoice {number}
              </a>{' '}
              <span className="mid">{INVOICE_STATES[state]}</span>
            </span>
            {open !== 0 && <span className="small nowrap">{amount(open, currency)} open</span>}
          </Row>
        ))}
      </Rows>
      {owed !== paid && (
        <p className="small p-3-inset">
          <Link className="link" to="/projects/$projectId/money" params={{ projectId }}>
            {side === 'team' ? 'Record payment' : invoices.length > 0 ? 'Invoices' : 'Draft invoice'}
          </Link>
        </p>
      )}
    </Card>
  )
}

function SlipCard({ sheet, side }: { sheet: MilestoneSheet; side: Side }) {
  const { slip, slips, slip_growth_days: growth, milestone } = sheet
  if (sheet.estimates === null || milestone.is_deposit) return null
  return (
    <Card aria-labelledby="slip">
      <CardHead id="slip" title="Late" end="visible to the two of you only" />
      <div className="p-3-inset">
        <p>{slip ? capital(slipInWords(slip, side)) : 'Not due yet'}.</p>
        {slips.length > 1 && (
          <Table
            label="Delays so far"
            rows={slips}
            keyOf={({ milestone_id: id }) => id}
            rowClass={({ milestone_id: id }) => (id === milestone.id ? 'strong' : undefined)}
            columns={[
              { head: 'Milestone', rowHead: true, cell: ({ name }) => name },
              { head: 'Late', cell: ({ days }) => plural(days, 'day') },
              { head: side === 'designer' ? 'with you' : 'with the designer', cell: (row) => row.designer_days },
              { head: side === 'designer' ? 'with the studio' : 'with you', cell: (row) => row.studio_days },
            ]}
          />
        )}
        {growth !== null && (
          <p className="small mid">
            {growth > 0
              ? `Each milestone is ${average(growth)} days later than the one before.`
              : growth < 0
                ? `Each milestone is ${average(-growth)} days less late than the one before.`
                : 'Delays are not growing.'}
          </p>
        )}
      </div>
    </Card>
  )
}

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1)
const error = (percent: number | null): string => (percent === null ? '' : `, ${deviation(percent)}`)

function EstimateCard({ sheet, side }: { sheet: MilestoneSheet; side: Side }) {
  const { estimates, milestone, cues } = sheet
  if (estimates === null || milestone.is_deposit) return null
  const own = new Set(cues.map(({ cue }) => cue.id))
  const ofCues = estimates.cues.filter(({ about_id }) => own.has(about_id))
  const whole = estimates.milestones.find(({ about_id }) => about_id === milestone.id)
  const forecast = estimates.forecasts.find(({ milestone_id }) => milestone_id === milestone.id)
  return (
    <Card aria-labelledby="estimates">
      <CardHead id="estimates" title="Estimates" end="visible to the two of you only" />
      <div className="p-3-inset">
        {whole && (
          <p className="small grid grid-cols-1-auto gap-0-3">
            <span className="mid">From signing to due date</span>
            <span>
              {plural(whole.estimate, 'day')}, {whole.actual === null ? 'so far' : 'actual'} {figure(whole.so_far)}
              {error(whole.error_percent)}
            </span>
          </p>
        )}
        {ofCues.map((row) => (
          <p key={row.about_id} className="small grid grid-cols-1-auto gap-0-3">
            <span className="mid">{row.name}</span>
            <span>
              {hours(row.estimate)}, {row.so_far > 0 ? `logged ${hours(row.so_far)}` : 'no time logged'}
              {error(row.error_percent)}
            </span>
          </p>
        ))}
        {!whole && ofCues.length === 0 && <p className="mid">The plan has no estimates for it.</p>}
        {forecast && (
          <p className="small">
            {forecast.forecast_on === forecast.due_on
              ? 'On time, based on earlier estimates.'
              : `Based on earlier estimates, done on ${day(forecast.forecast_on)}.`}
          </p>
        )}
        {estimates.warning !== null && <p className="small tone-warn">{estimates.warning}</p>}
      </div>
      {side === 'designer' && sheet.contract_state === 'agreed' && ofCues.length > 0 && (
        <LogWork contractId={sheet.contract_id} cues={cues.map(({ cue }) => cue)} />
      )}
    </Card>
  )
}

/** The designer's own note of time, which the estimates are held against. */
function LogWork({ contractId, cues }: { contractId: string; cues: readonly { id: string; name: string }[] }) {
  const log = useLogWork(contractId)
  return (
    <Form
      className={`grid gap-3 ${classes.form}`}
      aria-label="Log time"
      initialValues={{ cue_id: cues[0]?.id ?? '', minutes: '', worked_on: today() }}
      mutation={log}
      checks={({ minutes }) => ({ minutes: !(Number(minutes) >= 1) && 'Enter minutes.' })}
      resets={({ cue_id, worked_on }) => ({ cue_id, worked_on })}
      onSubmit={(typed) => log.mutate({ ...typed, minutes: Math.round(Number(typed.minutes)) })}
    >
      <Field
        as={NativeSelect}
        name="cue_id"
        size="xs"
        label="Cue"
        data={cues.map(({ id, name }) => ({ value: id, label: name }))}
      />
      <Field as={NumberInput} name="minutes" label="Minutes" min={1} max={24 * 60} allowDecimal={false} />
      <Field name="worked_on" label="Worked on" type="date" />
      <Submit variant="plain" className="row wrap justify-end col-span-full">
        Log time
      </Submit>
    </Form>
  )
}
