import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { useRef, useState } from 'react'

import { Dialog } from '@/app/Dialog'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { figure, plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { Select } from '@/ui/Select'

import { type ComparedBid, type Comparison, comparisonQuery, useAward, useScore, useShortlist } from './api'
import classes from './Hiring.module.css'
import { Refusal } from './Refusal'
import { SampleLine } from './SampleLine'
import { type FilePlayer, useSamplePlayer } from './player'
import { sameOfNext } from './samples'
import { busyInWords } from './roster/words'
import { EXTRA_WORDS, period, UNIT_WORDS } from './words'

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
  const hasSamples = bids.some(({ samples }) => samples.some((one) => one.is_open))
  const playSame = () => {
    const next = sameOfNext(bids, player.playingId)
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
      <div>
        <h1>{`${plural(bids.length, 'bid')} on ${title}`}</h1>
        <p className="mid">
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
        </p>
      </div>
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
          <div ref={scores}>
            <ScoreCard key={chosen.id} comparison={comparison} bid={chosen} />
          </div>
        </>
      )}
      {awarding && (
        <AwardDialog comparison={comparison} bid={awarding} projectId={projectId} onClose={() => setAwarding(null)} />
      )}
    </>
  )
}

interface BidsTableProps {
  comparison: Comparison
  chosenId: string
  player: FilePlayer
  onMark: (bid: ComparedBid) => void
  onAward: (bid: ComparedBid) => void
}

function BidsTable({ comparison, chosenId, player, onMark, onAward }: BidsTableProps) {
  const { bids, lines, currency, headings, rate_floor_minor: floor } = comparison
  const extras = [
    ...new Set(
      bids.flatMap(({ content }) => content.lines.filter(({ kind }) => kind !== 'asked').map(({ kind }) => kind)),
    ),
  ]
  const of = (bid: ComparedBid) => (bid.id === chosenId ? classes.chosen : undefined)
  const row = (name: string, cell: (bid: ComparedBid) => React.ReactNode) => (
    <tr key={name}>
      <th scope="row">{name}</th>
      {bids.map((bid) => (
        <td key={bid.id} className={of(bid)}>
          {cell(bid)}
        </td>
      ))}
    </tr>
  )
  const offered = (bid: ComparedBid, wanted: (line: ComparedBid['content']['lines'][number]) => boolean) => {
    const found = bid.content.lines
      .map((line, at) => ({ line, minor: bid.amounts_minor[at] ?? 0 }))
      .filter(({ line }) => wanted(line))
    if (found.length === 0) return <span className="mid">not offered</span>
    return found.map(({ line, minor }, at) => (
      <span key={at} className={classes.cell}>
        <span className="num">{money(minor, currency)}</span>
        <span className="mid">
          {line.unit === 'flat' ? line.key || 'flat' : `${money(line.price_minor, currency)} ${UNIT_WORDS[line.unit]}`}
        </span>
      </span>
    ))
  }
  return (
    // Wide tables scroll by themselves; the focus lets the arrow keys do it.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
    <section className={classes.scroll} aria-label="Bids side by side" tabIndex={0}>
      <table className={classes.table}>
        <thead>
          <tr>
            <th scope="col">Shortlist first, then as they came</th>
            {bids.map((bid, at) => (
              <th scope="col" key={bid.id} className={of(bid)}>
                <span className={classes.cell}>
                  <span className="lead">{`${at + 1} ${bid.designer.name}`}</span>
                  <Button
                    variant="quiet"
                    pressed={bid.is_shortlisted}
                    aria-label={`Shortlist ${bid.designer.name}`}
                    onClick={() => onMark(bid)}
                  >
                    {bid.is_shortlisted ? 'Shortlisted' : 'Shortlist'}
                  </Button>
                </span>
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {lines.map((line) =>
            row(`${line.label}, ${plural(line.cues, 'cue')}`, (bid) =>
              offered(bid, ({ kind, key }) => kind === 'asked' && key === line.key),
            ),
          )}
          {extras.map((extra) =>
            row(extra === 'asked' ? '' : EXTRA_WORDS[extra], (bid) => offered(bid, ({ kind }) => kind === extra)),
          )}
          {row('Total', (bid) => (
            <>
              <span className="lead num">{money(bid.total_minor, currency)}</span>
              {bid.missing.length > 0 && (
                <p className="tone-warn">
                  <span className="toned">{`without ${bid.missing.join(', ')}: not comparable`}</span>
                </p>
              )}
              {bid.over_budget_minor !== null && bid.missing.length === 0 && (
                <p className={bid.over_budget_minor > 0 ? 'tone-warn' : 'mid'}>
                  <span className="toned">{overBudget(bid.over_budget_minor, currency)}</span>
                </p>
              )}
            </>
          ))}
          {row('Hours, effective rate', (bid) => {
            const { hours_hundredths: hours } = bid.content
            if (typeof hours !== 'number' || bid.hourly_rate_minor === null)
              return <span className="mid">not named</span>
            return (
              <span className={classes.cell}>
                <span className="num">{figure(hours / 100, hours % 100 === 0 ? 0 : 2)}</span>
                <span className={bid.is_below_floor ? 'tone-warn' : 'mid'}>
                  <span className="toned">
                    {`${money(bid.hourly_rate_minor, currency)} an hour`}
                    {bid.is_below_floor && floor !== null ? `, your floor is ${money(floor, currency)}` : ''}
                  </span>
                </span>
              </span>
            )
          })}
          {row('Dates offered', (bid) => (
            <>
              {period(bid.content.from_on ?? null, bid.content.to_on ?? null)}
              {bid.days_late !== null && (
                <p className="tone-warn">
                  <span className="toned">{`${plural(bid.days_late, 'day')} late`}</span>
                </p>
              )}
            </>
          ))}
          {bids.some((bid) => bid.roster_entry_id) && row('Busy, by the roster', (bid) => <BusyCell bid={bid} />)}
          {bids.some(({ samples }) => samples.length > 0) &&
            lines
              .filter(({ key }) => bids.some(({ samples }) => samples.some((one) => one.line_key === key)))
              .map(({ key, label }) =>
                row(`Samples, ${label}`, (bid) => {
                  const ofLine = bid.samples.filter((one) => one.line_key === key)
                  if (ofLine.length === 0) return <span className="mid">none</span>
                  return ofLine.map((one) => (
                    <SampleLine key={one.id} sample={one} {...player} onToggle={player.toggle} />
                  ))
                }),
              )}
          {row('Note', (bid) => (
            <span className={classes.text}>{bid.content.note}</span>
          ))}
          {headings.map((heading) => row(heading, (bid) => <Marks bid={bid} heading={heading} />))}
          {row('Award opens a draft contract with these figures', (bid) => (
            <span className={classes.cell}>
              <span className="mid">{`${bid.scored_by} scored`}</span>
              {comparison.awarded_bid_id === bid.id && <span className="strong">Awarded</span>}
              {comparison.may_award && (
                <Button variant={bid.id === chosenId ? 'primary' : 'plain'} onClick={() => onAward(bid)}>
                  {`Award to ${bid.designer.name}`}
                </Button>
              )}
            </span>
          ))}
        </tbody>
      </table>
    </section>
  )
}

/** What the roster notes of a bidder's days, and the way there. */
function BusyCell({ bid }: { bid: ComparedBid }) {
  if (bid.roster_entry_id === null) return <span className="mid">not on file</span>
  return (
    <span className={classes.cell}>
      {bid.busy.length === 0 ? (
        <span className="mid">nothing noted</span>
      ) : (
        <span className="tone-warn">
          <span className="toned">{bid.busy.map(busyInWords).join('; ')}</span>
        </span>
      )}
      <Link className="link" to="/roster/$entryId" params={{ entryId: bid.roster_entry_id }}>
        on file
      </Link>
    </span>
  )
}

const overBudget = (minor: number, currency: string): string => {
  if (minor === 0) return 'exactly the budget'
  return minor > 0 ? `${money(minor, currency)} over the budget` : `${money(-minor, currency)} under the budget`
}

/** One mark a person; nobody sees the others' before giving their own. */
function Marks({ bid, heading }: { bid: ComparedBid; heading: string }) {
  if (bid.others === null) {
    const own = bid.own_scores?.scores[heading]
    return <span className="mid">{own === undefined ? 'Score it to see the team’s' : `Yours: ${own}`}</span>
  }
  const all = [...(bid.own_scores ? [bid.own_scores] : []), ...bid.others]
  const given = all.flatMap(({ person, scores }) =>
    scores[heading] === undefined ? [] : [{ person, score: scores[heading] }],
  )
  const mean = given.reduce((sum, { score }) => sum + score, 0) / Math.max(1, given.length)
  return (
    <span className={classes.cell}>
      <span className="num">{figure(mean, 1)}</span>
      <span className="mid">{given.map(({ person, score }) => `${person.name} ${score}`).join(', ')}</span>
    </span>
  )
}

function ScoreCard({ comparison, bid }: { comparison: Comparison; bid: ComparedBid }) {
  const { headings, posting_id: postingId } = comparison
  const [now, set, draft] = useDraft(`scores:${bid.id}`, {
    scores: bid.own_scores?.scores ?? {},
    note: bid.own_scores?.note ?? '',
  })
  const score = useScore(postingId)
  const left = headings.filter((heading) => now.scores[heading] === undefined)
  const send = () => score.mutate({ id: bid.id, ...now }, { onSuccess: () => draft.discard() })
  return (
    <Card aria-labelledby="scores">
      <CardHead
        id="scores"
        title={`Your scores for ${bid.designer.name}`}
        note={left.length > 0 ? `${left.length} to give` : undefined}
      />
      <div className={classes.form}>
        <div className={classes.wide}>
          <DraftNote draft={draft} />
        </div>
        {headings.map((heading) => (
          <Select
            key={heading}
            label={heading}
            value={now.scores[heading] ?? ''}
            onChange={({ currentTarget: { value } }) =>
              set((before) => ({ ...before, scores: { ...before.scores, [heading]: Number(value) } }))
            }
          >
            <option value="" disabled>
              1 to 5
            </option>
            {[1, 2, 3, 4, 5].map((value) => (
              <option key={value} value={value}>
                {value}
              </option>
            ))}
          </Select>
        ))}
        <Textarea
          className={classes.wide}
          label="Note"
          maxLength={5000}
          value={now.note}
          onChange={({ currentTarget: { value: note } }) => set((before) => ({ ...before, note }))}
        />
        <div className={classes.wide}>
          <Refusal error={score.error} />
          <Button aria-busy={score.isPending} onClick={send}>
            Save scores
          </Button>
        </div>
        {bid.others
          ?.filter(({ note }) => note !== '')
          .map(({ person, note }) => (
            <p key={person.id} className={classes.wide}>
              <span className="strong">{person.name}</span> {note}
            </p>
          ))}
      </div>
    </Card>
  )
}

interface AwardDialogProps {
  comparison: Comparison
  bid: ComparedBid
  projectId: string
  onClose: () => void
}

/** Names who gets which email, before anything happens. */
function AwardDialog({ comparison, bid, projectId, onClose }: AwardDialogProps) {
  const award = useAward(comparison.posting_id)
  const navigate = useNavigate()
  const others = comparison.bids.filter(({ id }) => id !== bid.id).map(({ designer }) => designer.name)
  const send = () => {
    if (award.isPending) return
    award.mutate(bid.id, {
      onSuccess: ({ contract_id: contractId }) =>
        void navigate({ to: '/projects/$projectId/contracts/$contractId/draft', params: { projectId, contractId } }),
    })
  }
  return (
    <Dialog title={`Award ${comparison.title} to ${bid.designer.name}?`} opened onClose={onClose}>
      <div className={classes.dialog}>
        <p>{`${bid.designer.name} gets an email that the bid was chosen, and joins the project.`}</p>
        {others.length > 0 && (
          <p>{`${others.join(', ')}: thanked by email, and informed that another bid was chosen.`}</p>
        )}
        <p>{`A draft contract over ${money(bid.total_minor, comparison.currency)} opens. Nothing is signed.`}</p>
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
