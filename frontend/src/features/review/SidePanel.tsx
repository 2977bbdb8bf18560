import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type Dispatch, type KeyboardEvent, type ReactNode, type SetStateAction, useState } from 'react'

import { isWaitingId } from '@/api/offlineOutbox'
import { meQuery } from '@/api/me'
import { useRoles } from '@/api/roles'
import { type CueReview, historyQuery, type ReviewFinding, type ReviewTake } from '@/verdicts/api'
import { notesBlock } from '@/verdicts/blocked'
import { MentionedText } from '@/verdicts/MentionedText'
import { ReplyField } from '@/verdicts/ReplyField'
import { byWhom, capital, happened, sentence, spot, historyText } from '@/verdicts/words'
import { ReferencesWhereAny } from '@/references/ReferencesWhereAny'
import { TakeSourcesPart } from '@/sources/TakeSourcesPart'
import { Button } from '@/ui/Button'
import { Avatar } from '@/ui/Avatar'
import { Finding } from '@/ui/Finding'
import { age, clock, day } from '@/ui/format'
import { Key } from '@/ui/Key'
import { Person } from '@/ui/Person'
import { Refusal } from '@/ui/Refusal'
import { useLazy } from '@/ui/useLazy'

import { type Comment, useComment, useMarkComment } from './api'
import type { Carried } from './carried'
import { Composer, type Writing } from './Composer'
import { Figures } from './Figures'
import { PalettePlot } from './PalettePlot'
import classes from './Side.module.css'
import { roleOfSaid, type FeedbackItem } from './feedback'

interface SidePanelProps {
  review: CueReview
  projectId: string
  hand: ReviewTake | undefined
  heard: readonly ReviewTake[]
  nameOf: (take: ReviewTake) => string
  said: readonly FeedbackItem[]
  carried: readonly Carried[]
  openSaid: string | undefined
  onOpen: (item: FeedbackItem) => void
  onSpot: (startS: number) => void
  writing: Writing | null
  onWriting: Dispatch<SetStateAction<Writing | null>>
  comment: ReturnType<typeof useComment>
  blind: boolean
}

const loadCarriedNotes = () => import('./CarriedNotes').then(({ CarriedNotes }) => CarriedNotes)
const loadWaiver = () => import('./Waiver').then(({ Waiver }) => Waiver)
const loadGameFiles = () => import('./GameFiles').then(({ GameFiles }) => GameFiles)

type Tab = 'comments' | 'details'

/** What was said; and in a second tab everything that is known of the version. */
export function SidePanel(props: SidePanelProps) {
  const { hand, said, blind, writing } = props
  const [chosen, setTab] = useState<Tab>('comments')
  const tab = writing ? 'comments' : chosen
  const tabs: { id: Tab; label: string }[] = [
    { id: 'comments', label: `Comments ${blind ? '' : said.length}`.trim() },
    { id: 'details', label: 'Details' },
  ]
  const onKeyDown = (event: KeyboardEvent) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key]
    if (by === undefined) return
    event.preventDefault()
    const to = tabs[(tabs.findIndex(({ id }) => id === tab) + by + tabs.length) % tabs.length]
    if (!to) return
    setTab(to.id)
    document.getElementById(`tab-${to.id}`)?.focus()
  }

  return (
    <aside
      className={`flex flex-col min-w-0 min-h-0 border-l bg-surface ${classes.side}`}
      aria-label="About this version"
    >
      <div role="tablist" aria-label="About this version" className={`flex border-b flex-none ${classes.tabs}`}>
        {tabs.map(({ id, label }) => (
          <button
            key={id}
            type="button"
            role="tab"
            id={`tab-${id}`}
            aria-selected={tab === id}
            aria-controls={`panel-${id}`}
            tabIndex={tab === id ? 0 : -1}
            onClick={() => setTab(id)}
            onKeyDown={onKeyDown}
          >
            {label}
          </button>
        ))}
      </div>
      <div
        role="tabpanel"
        id={`panel-${tab}`}
        aria-labelledby={`tab-${tab}`}
        className="flex-1 min-h-0 overflow-y-auto"
      >
        {blind ? (
          <p className={`${classes.quiet} mid`}>
            Comments and details are hidden until you pick, or press <Key keys="d" />
            <span className="visually-hidden">d</span> again.
          </p>
        ) : (
          <>
            {tab === 'comments' && <Comments {...props} />}
            {tab === 'details' && hand && <Details {...props} hand={hand} />}
          </>
        )}
      </div>
      {hand && writing && <Composer key={String(writing.isRestored)} {...props} hand={hand} writing={writing} />}
    </aside>
  )
}

function Comments({ review, projectId, hand, heard, nameOf, said, carried, openSaid, onOpen, onSpot }: SidePanelProps) {
  const mark = useMarkComment(review.cue.id)
  const { data: me } = useQuery(meQuery)
  const replying = useComment(review.cue.id)
  const roleOf = useRoles(projectId)
  const CarriedNotes = useLazy(loadCarriedNotes, carried.length > 0)
  const reply = async ({ id, takeId, kind }: FeedbackItem, text: string) => {
    const answers = kind === 'change' ? { change_request_id: id } : { reply_to_id: id }
    await replying.mutateAsync({ takeId, text, answers })
  }
  return (
    <>
      {hand && CarriedNotes && carried.length > 0 && (
        <CarriedNotes
          carried={carried}
          hand={hand}
          cueId={review.cue.id}
          projectId={projectId}
          areBlocking={notesBlock(review.checklist.blockers)}
          onSpot={onSpot}
        />
      )}
      {said.length === 0 && <p className={`${classes.quiet} mid`}>No comments yet</p>}
      <ul aria-label="Comments">
        {said.map((item) => (
          <SaidLine
            key={item.id}
            item={item}
            roleOf={roleOf}
            open={item.id === openSaid}
            on={aboutAnother(item, hand, heard, nameOf)}
            onOpen={() => onOpen(item)}
            onReply={item.draft || isWaitingId(item.id) ? undefined : (text) => reply(item, text)}
            myId={me?.person.id}
            onMark={(id, as) => mark.mutate({ id, as })}
          />
        ))}
      </ul>
      <Refusal error={mark.error} />
      <Refusal error={replying.error} />
      {hand && (hand.note || hand.delivery_note) && (
        <section className={classes.block} aria-label="Designer’s note">
          <p className="row small">
            <span className="strong">Designer’s note</span>
            <span className="dim end">delivery {hand.delivery_number}</span>
          </p>
          <p className="mid">{[hand.note, hand.delivery_note].filter(Boolean).join(' ')}</p>
        </section>
      )}
    </>
  )
}

/** What was found in the version, what it is made into, what it is compared with, and what happened. */
function Details({ review, projectId, hand, heard, nameOf, onSpot }: SidePanelProps & { hand: ReviewTake }) {
  const mayWaive = hand.state === 'returned' && review.may_approve
  const Waiver = useLazy(loadWaiver, mayWaive)
  const GameFiles = useLazy(loadGameFiles, true)
  return (
    <>
      <Findings take={hand} onSpot={onSpot} />
      {mayWaive && Waiver && <Waiver key={hand.id} take={hand} cueId={review.cue.id} projectId={projectId} />}
      <Figures take={hand} />
      {GameFiles && <GameFiles key={hand.id} take={hand} />}
      <div className={classes.block}>
        <ReferencesWhereAny projectId={projectId} cueId={review.cue.id} />
      </div>
      <section className={classes.block} aria-label="Sources">
        <p className="small strong">Sources</p>
        <TakeSourcesPart key={hand.id} takeId={hand.id} mayState={false} />
      </section>
      <PalettePlot
        projectId={projectId}
        takes={review.cue.variations > 1 || !heard.includes(hand) ? [hand] : heard}
        hand={hand}
        nameOf={nameOf}
      />
      <History take={hand} projectId={projectId} />
    </>
  )
}

function aboutAnother(
  item: FeedbackItem,
  hand: ReviewTake | undefined,
  heard: readonly ReviewTake[],
  nameOf: (take: ReviewTake) => string,
): string | null {
  const take = heard.find(({ id }) => id === item.takeId)
  return take && take.id !== hand?.id ? nameOf(take) : null
}

interface SaidLineProps {
  item: FeedbackItem
  roleOf: ReturnType<typeof useRoles>
  open: boolean
  /** Which other version it is said of. */
  on: string | null
  onOpen: () => void
  /** The current person's id. */
  myId: string | undefined
  onMark: (commentId: string, as: 'resolve' | 'reopen' | 'acknowledgement') => void
  /** Send a reply; undefined for what is not sent itself. */
  onReply?: (text: string) => Promise<void>
}

function SaidLine({ item, roleOf, open, on, onOpen, myId, onMark, onReply }: SaidLineProps) {
  const [replying, setReplying] = useState(false)
  const where = spot(item.startS, item.endS)
  const { comment } = item
  const resolved = Boolean(comment?.resolved_at)
  const role = roleOfSaid(item)
  return (
    <li className={`border-b ${classes.said}`} data-open={open || undefined} data-resolved={resolved || undefined}>
      <button
        type="button"
        className="row min-h-24px pointer w-full p-0 border-0 bg-none"
        aria-expanded={open}
        aria-label={['Comment', item.number, 'by', item.who, where].filter((word) => word != null).join(' ')}
        onClick={onOpen}
      >
        {item.number !== null && <span className={`flex-none strong ${classes.saidNumber}`}>{item.number}</span>}
        <Avatar name={item.who} picture={item.picture} />
        <span className="strong cut-text">{item.who}</span>
        <span className={item.kind === 'change' ? 'small tone-change toned nowrap' : 'small dim nowrap'}>{role}</span>
        <span className="small mono dim end nowrap">{where}</span>
      </button>
      <p className={`pre-line wrap-anywhere ${classes.saidText}`}>
        {on && <span className="dim">On {on}: </span>}
        <MentionedText text={item.text} mentions={item.mentions} />
        {resolved && <span className="dim"> Resolved.</span>}
      </p>
      {comment && <SeenLine comment={comment} myId={myId} onSeen={() => onMark(comment.id, 'acknowledgement')} />}
      {item.replies.length > 0 && (
        <ul className={`grid gap-6px ${classes.replies}`} aria-label={`Replies to ${item.who}`}>
          {item.replies.map((reply) => (
            <li key={reply.id}>
              <Person name={reply.author.name} picture={reply.author.picture} role={roleOf(reply.author.id)} />{' '}
              <span className="small dim">{age(reply.created_at)}</span>
              <p>
                <MentionedText text={reply.text} mentions={reply.mentions} />
              </p>
              <SeenLine comment={reply} myId={myId} onSeen={() => onMark(reply.id, 'acknowledgement')} />
            </li>
          ))}
        </ul>
      )}
      {replying && onReply && (
        <ReplyField
          takeId={item.takeId}
          to={item.who}
          draftKey={`reply:${item.id}`}
          onSend={onReply}
          onClose={() => setReplying(false)}
        />
      )}
      {open && (comment || onReply) && (
        <p className={classes.saidActs}>
          {onReply && !replying && (
            <Button variant="quiet" className="small" onClick={() => setReplying(true)}>
              Reply<span className="visually-hidden"> to {item.who}</span>
            </Button>
          )}
          {comment && (
            <Button
              variant="quiet"
              className="small"
              onClick={() => onMark(comment.id, resolved ? 'reopen' : 'resolve')}
            >
              {resolved ? 'Reopen' : 'Resolve'}
              <span className="visually-hidden"> what {item.who} said</span>
            </Button>
          )}
        </p>
      )}
    </li>
  )
}

interface SeenLineProps {
  comment: Comment
  myId: string | undefined
  onSeen: () => void
}

/** Who has acknowledged a comment; whom it mentions does so here. */
function SeenLine({ comment, myId, onSeen }: SeenLineProps) {
  const { mentions, acknowledgements, author } = comment
  const isDue =
    mentions.some(({ person_id: id }) => id === myId) && !acknowledgements.some(({ person }) => person.id === myId)
  if (!isDue && acknowledgements.length === 0) return null
  return (
    <p className="row small dim">
      {acknowledgements.length > 0 && (
        <span>Seen by {acknowledgements.map(({ person }) => person.name).join(', ')}</span>
      )}
      {isDue && (
        <Button variant="quiet" className="small" icon="tick" onClick={onSeen}>
          Seen<span className="visually-hidden">: what {author.name} said</span>
        </Button>
      )}
    </p>
  )
}

const worstFirst = (findings: readonly ReviewFinding[]): ReviewFinding[] =>
  [...findings].sort((a, b) => Number(a.severity !== 'error') - Number(b.severity !== 'error'))

function Findings({ take, onSpot }: { take: ReviewTake; onSpot: (startS: number) => void }) {
  if (take.findings.length === 0) {
    return <p className={`${classes.quiet} mid`}>All checks passed.</p>
  }
  return (
    <div className={`grid gap-3 ${classes.findings}`}>
      <p className="small">
        <Link className="link" to="/takes/$takeId" params={{ takeId: take.id }}>
          All measurements
        </Link>
      </p>
      {take.waived && (
        <p className="small mid">
          Waived by the approver{take.waiver_reason ? `: “${take.waiver_reason}”` : ''}. The findings are kept.
        </p>
      )}
      {worstFirst(take.findings).map((finding, index) => (
        <Finding
          key={`${finding.code} ${index}`}
          severity={finding.severity}
          head={sentence(finding.message)}
          where={spot(finding.start_s, finding.end_s)}
          actions={
            <>
              {finding.start_s !== null && finding.start_s !== undefined && (
                <Button onClick={() => onSpot(finding.start_s ?? 0)}>Go to position</Button>
              )}
              <Link className="link small" to="/checks/$check" params={{ check: finding.check }}>
                {finding.check}
              </Link>
            </>
          }
        >
          {finding.waived ? 'Waived. ' : ''}
          {capital(finding.fix)}.{finding.auto_fix && ` A fix ${finding.auto_fix}.`}
        </Finding>
      ))}
    </div>
  )
}

function History({ take, projectId }: { take: ReviewTake; projectId: string }) {
  const history = useQuery(historyQuery(take.id))
  if (history.error) {
    return <Refusal error={history.error} />
  }
  return (
    <>
      <p className={`small ${classes.quiet}`}>
        <Link className="link" to="/projects/$projectId/reasons" params={{ projectId }} search={{}}>
          Reasons of all verdicts
        </Link>
      </p>
      <ol aria-label="History" className={classes.history}>
        {history.data?.toReversed().map((entry, index) => (
          <li key={`${entry.at} ${index}`}>
            <p className="row small">
              <span className="strong">{happened(entry)}</span>
              <span className="mid cut-text">{byWhom(entry)}</span>
              <time dateTime={entry.at} className="dim end nowrap" title={`${day(entry.at)}, ${clock(entry.at)}`}>
                {age(entry.at)}
              </time>
            </p>
            {historyText(entry) && <Quoted spotWords={spot(entry.start_s, entry.end_s)}>{historyText(entry)}</Quoted>}
          </li>
        ))}
      </ol>
    </>
  )
}

function Quoted({ spotWords, children }: { spotWords?: string; children: ReactNode }) {
  return (
    <p className="mid small">
      {spotWords && <span className="mono dim">{spotWords} </span>}
      {children}
    </p>
  )
}
