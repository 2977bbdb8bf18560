import { Link } from '@tanstack/react-router'

import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { figure, plural } from '@/ui/format'

import { type ComparedBid, type Comparison } from './api'
import classes from './Hiring.module.css'
import { SampleLine } from './SampleLine'
import { type FilePlayer } from './player'
import { busyInWords, EXCLUSIVITY_WORDS } from './roster/words'
import { EXTRA_WORDS, period, UNIT_WORDS } from './words'

interface BidsTableProps {
  comparison: Comparison
  chosenId: string
  player: FilePlayer
  onMark: (bid: ComparedBid) => void
  onAward: (bid: ComparedBid) => void
}

/** Bids in columns, with the same lines of each beside each other. */
export function BidsTable({ comparison, chosenId, player, onMark, onAward }: BidsTableProps) {
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
  const offered = (bid: ComparedBid, matches: (line: ComparedBid['content']['lines'][number]) => boolean) => {
    const priced = bid.content.lines
      .map((line, at) => ({ line, minor: bid.amounts_minor[at] ?? 0 }))
      .filter(({ line }) => matches(line))
    if (priced.length === 0) return <span className="mid">not offered</span>
    return priced.map(({ line, minor }, at) => (
      <span key={at} className="flex between gap-3">
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
    <section className="overflow-x-auto" aria-label="Bids side by side" tabIndex={0}>
      <table className={`w-full ${classes.table}`}>
        <thead>
          <tr>
            <th scope="col">Shortlist first, then as they came</th>
            {bids.map((bid, at) => (
              <th scope="col" key={bid.id} className={of(bid)}>
                <span className="flex between gap-3">
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
              {bid.concept_minor > 0 && (
                <p className="tone-warn">
                  <span className="toned">{`${money(bid.concept_minor, currency)} of it for concepts`}</span>
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
              <span className="flex between gap-3">
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
              .filter(({ key }) => bids.some(({ samples }) => samples.some((sample) => sample.line_key === key)))
              .map(({ key, label }) =>
                row(`Samples, ${label}`, (bid) => {
                  const ofLine = bid.samples.filter((sample) => sample.line_key === key)
                  if (ofLine.length === 0) return <span className="mid">none</span>
                  return ofLine.map((sample) => (
                    <SampleLine key={sample.id} sample={sample} {...player} onToggle={player.toggle} />
                  ))
                }),
              )}
          {bids.some(({ content }) => content.exclusivity !== 'unknown') &&
            row('Other projects', ({ content }) => EXCLUSIVITY_WORDS[content.exclusivity ?? 'unknown'])}
          {bids.some(({ content }) => content.other_work) &&
            row('Other work in these days', ({ content }) => (
              <span className={`pre-line ${classes.text}`}>{content.other_work}</span>
            ))}
          {bids.some(({ content }) => content.equipment) &&
            row('Equipment', ({ content }) => <span className={`pre-line ${classes.text}`}>{content.equipment}</span>)}
          {row('Note', (bid) => (
            <span className={`pre-line ${classes.text}`}>{bid.content.note}</span>
          ))}
          {headings.map((heading) => row(heading, (bid) => <Marks bid={bid} heading={heading} />))}
          {row('Award opens a draft contract with these figures', (bid) => (
            <span className="flex between gap-3">
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
    <span className="flex between gap-3">
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
    <span className="flex between gap-3">
      <span className="num">{figure(mean, 1)}</span>
      <span className="mid">{given.map(({ person, score }) => `${person.name} ${score}`).join(', ')}</span>
    </span>
  )
}
