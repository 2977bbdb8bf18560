import { useEffect, useMemo, useState } from 'react'
import { flushSync } from 'react-dom'

import { keepDraft, keptDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { type Player, type PlayerState, spotOf } from '@/audio'
import type { CueReview, ReviewTake } from '@/judging/api'
import { isWholeSet, pickedOfSet } from '@/judging/choice'
import { inOrder, LETTERS, soundOf, sourceOf, targetsOf } from '@/judging/hearing'
import { useHearing } from '@/judging/useHearing'
import type { Judge } from '@/judging/useJudge'
import { takeName } from '@/judging/words'
import type { CueMoney } from '@/money/api'

import { useComment } from './api'
import { shuffled } from './blind'
import { Asked } from './Asked'
import { CueHead } from './CueHead'
import classes from './Review.module.css'
import { marksOf, type Said, saidOf } from './said'
import { SetRows } from './SetRows'
import { SidePanel, type Writing } from './SidePanel'
import { TakeCards } from './TakeCards'
import { Transport } from './Transport'
import { Verdict } from './Verdict'
import { WaveStage } from './WaveStage'

interface CueRoomProps {
  review: CueReview
  /** What its contract says of the cue; null where there is none, or the reader has no sight of money. */
  money: CueMoney | null
  projectId: string
  mayCut: boolean
  player: Player
  playing: PlayerState
  target: string
  onTarget: (target: string) => void
  judge: Judge
  /** How many wait in the queue. */
  waiting: number | string
  onQueue: () => void
  onJudged: () => void
  startTakeId?: string
  startS?: number
}

/** The version that is heard first: the one asked for, then what waits, then what was approved, then the newest. */
function firstInHand(review: CueReview, waiting: readonly ReviewTake[], wanted?: string): string | undefined {
  const newest = review.takes.find(({ state }) => state === 'approved') ?? review.takes[0]
  const asked = review.takes.find(({ id }) => id === wanted)
  return (asked ?? waiting.find(({ draft_change }) => draft_change === null) ?? waiting[0] ?? newest)?.id
}

/** One cue on the stage, and at its side what was said and found. */
export function CueRoom(props: CueRoomProps) {
  const { review, projectId, player, playing, target, onTarget, judge, onJudged } = props
  const { cue } = review
  const waiting = useMemo(() => inOrder(review.takes.filter(({ state }) => state === 'conforming')), [review.takes])
  const [handId, setHandId] = useState(() => firstInHand(review, waiting, props.startTakeId))
  const [blind, setBlind] = useState<readonly string[] | null>(null)
  const [picked, setPicked] = useState<ReadonlySet<string>>(new Set())
  const [chosen, setChosen] = useState<ReadonlyMap<number, string>>(new Map())
  const [changing, setChanging] = useState<{ positionS: number } | null>(null)
  const [writing, setWriting] = useState<Writing | null>(null)
  useEffect(() => {
    if (writing !== null) keepDraft(`comment:${cue.id}`, writing.text.trim() === '' ? null : writing)
  }, [cue.id, writing])
  const [openSaid, setOpenSaid] = useState<string>()
  const comment = useComment(cue.id)

  const hand =
    review.takes.find(({ id }) => id === handId) ?? review.takes.find(({ id }) => id === firstInHand(review, waiting))
  const isSet = cue.variations > 1
  const heard = useMemo(() => {
    const takes = isSet && waiting.length === 0 ? review.takes.filter(({ state }) => state === 'approved') : waiting
    return blind ? blind.flatMap((id) => takes.find((take) => take.id === id) ?? []) : inOrder(takes)
  }, [isSet, waiting, review.takes, blind])
  // A version that answers a change is heard beside the one that the change was asked of.
  const current = heard[0]
  const before =
    heard.length === 1 && current
      ? review.takes.find(
          ({ variation, number, state }) =>
            variation === current.variation && number < current.number && state === 'change_requested',
        )
      : undefined
  const askedBefore = review.change_requests.filter(
    ({ take_id, sent_at }) => take_id === before?.id && sent_at !== null,
  )
  const flip = () => {
    const to = hand?.id === before?.id ? current : before
    if (to) choose(to)
  }
  const reference = heard[0]
  const source = useHearing(player, cue.id, hand, target, blind ? undefined : reference)
  const targets = targetsOf(review.takes)

  const { startS } = props
  useEffect(() => {
    if (startS !== undefined) player.seek(startS)
  }, [player, startS])

  const nameOf = (take: ReviewTake) => {
    const place = blind?.indexOf(take.id) ?? -1
    return place >= 0 ? (LETTERS[place] ?? '') : takeName(take, cue, waiting)
  }
  const said = saidOf(review, hand && heard.includes(hand) ? heard : hand ? [hand] : [])

  const choose = (take: ReviewTake) => {
    setHandId(take.id)
    if (isSet) setChosen((now) => new Map(now).set(take.variation, take.id))
  }
  const stepTake = (by: number) => {
    if (hand === undefined || heard.length < 2) return
    const at = heard.findIndex(({ id }) => id === hand.id)
    const to = heard[(at + by + heard.length) % heard.length]
    if (to) choose(to)
  }
  const pick = (extend: boolean) => {
    if (hand === undefined || !isSet) return
    const at = heard.indexOf(hand)
    const lastPicked = heard.findLastIndex(({ id }, index) => picked.has(id) && index !== at)
    setPicked((now) => {
      const next = new Set(now)
      if (extend && lastPicked >= 0) {
        for (const { id } of heard.slice(Math.min(at, lastPicked), Math.max(at, lastPicked) + 1)) next.add(id)
      } else if (!next.delete(hand.id)) next.add(hand.id)
      return next
    })
  }

  const meant = picked.size > 0 ? heard.filter(({ id }) => picked.has(id)) : hand ? [hand] : []
  const realName = (take: ReviewTake) => takeName(take, cue, waiting)
  const meantName = meant.length > 1 ? `${meant.length} variations` : meant.map(realName).join('')
  const whole = isWholeSet(cue, waiting, review.approved_variations)

  const leaves = (takes: readonly ReviewTake[]) => {
    const variations = new Set(takes.map(({ variation }) => variation))
    return waiting.every((take) => variations.has(take.variation) || take.draft_change !== null)
  }
  const approve = () => {
    if (meant.length === 0) return
    player.pause()
    const last = leaves(meant)
    void judge.approve(cue, meant, meantName)
    setBlind(null)
    setPicked(new Set())
    if (last) onJudged()
    else {
      const decided = new Set(meant.map(({ variation }) => variation))
      const next = waiting.find((take) => !decided.has(take.variation) && take.draft_change === null)
      if (next) setHandId(next.id)
    }
  }
  const acceptSet = () => {
    player.pause()
    void judge.acceptSet(cue, waiting, pickedOfSet(waiting, chosen))
    onJudged()
  }
  const openChange = () => {
    player.pause()
    judge.change.reset()
    flushSync(() => setChanging({ positionS: inside(player.positionS(), hand, target) }))
  }
  const write = (text = '') => {
    if (hand === undefined) return
    const range = playing.range
    const startS = range?.startS ?? inside(player.positionS(), hand, target)
    const kept = text === '' ? keptDraft<Writing>(`comment:${cue.id}`) : null
    flushSync(() => setWriting(kept ? { ...kept, isRestored: true } : { text, startS, endS: range?.endS }))
  }
  const wouldTake = () => {
    if (hand === undefined) return
    comment.mutate(
      { takeId: hand.id, text: `I’d pick ${realName(hand)}.` },
      { onSuccess: () => showToast(`Comment sent: I’d pick ${realName(hand)}.`) },
    )
  }
  const goTo = (one: Said) => {
    setOpenSaid(one.id)
    const take = review.takes.find(({ id }) => id === one.takeId)
    if (take && take.id !== hand?.id) choose(take)
    if (one.startS !== null) playFrom(one.startS)
  }
  const playFrom = (startAtS: number) => {
    player.seek(spotOf(startAtS))
    if (!player.isPlaying()) void player.play(spotOf(startAtS))
  }
  const toggleBlind = () => {
    player.pause()
    if (blind) {
      setBlind(null)
      return
    }
    const order = shuffled(waiting.map(({ id }) => id))
    setBlind(order)
    setHandId(order[0])
  }
  const asGame = () => void player.playAsGame(heard.flatMap((take) => sourceOf(take, target, reference) ?? []))
  const setEnd = (end: 'startS' | 'endS') => {
    if (hand === undefined) return
    const { durationS } = soundOf(hand, target)
    const now = playing.range ?? { startS: 0, endS: durationS }
    player.setRange({ ...now, [end]: player.positionS() })
  }
  const canBlind = !isSet && waiting.length > 1

  useHotkeys([
    ...heard.slice(0, 9).map((take, index) => ({
      keys: String(index + 1),
      label: isSet ? 'Choose a variation' : 'Choose an alternate',
      group: 'Review',
      unlisted: index > 0,
      run: () => choose(take),
    })),
    { keys: '[', label: 'Loop from here', group: 'Review', run: () => setEnd('startS') },
    { keys: ']', label: 'Loop to here', group: 'Review', run: () => setEnd('endS') },
    {
      keys: 't',
      label: 'Master, then each game file',
      group: 'Review',
      run: () => onTarget(targets[(targets.indexOf(target) + 1) % targets.length] ?? target),
      disabled: targets.length < 2,
    },
    { keys: 'x', label: 'Select the variation', group: 'Review', run: () => pick(false), disabled: !isSet },
    { keys: 'shift+x', label: 'Select range to here', group: 'Review', run: () => pick(true), disabled: !isSet },
    { keys: 'c', label: 'Comment here', group: 'Review', run: () => write() },
    { keys: 'y', label: 'Leave a positive note', group: 'Review', run: () => write('Keep this. ') },
    {
      keys: 'h',
      label: 'Hold to play the set randomised, as in game',
      group: 'Review',
      run: asGame,
      release: () => player.pause(),
      disabled: !isSet,
    },
  ])

  return (
    <>
      <section className={classes.stage} aria-label={cue.name}>
        <CueHead
          review={review}
          hand={hand}
          waitingHere={waiting.length > 0}
          blind={blind !== null}
          targets={targets}
          target={target}
          onTarget={onTarget}
          onTake={choose}
          projectId={projectId}
          mayCut={props.mayCut}
          onCut={onJudged}
          queued={props.waiting}
          onQueue={props.onQueue}
        />
        {!isSet && heard.length > 1 && (
          <TakeCards takes={heard} handId={hand?.id} nameOf={nameOf} blind={blind !== null} onChoose={choose} />
        )}
        {isSet && heard.length > 0 && (
          <SetRows takes={heard} handId={hand?.id} nameOf={nameOf} picked={picked} onChoose={choose} cue={cue} />
        )}
        {before && current && (
          <Asked
            asked={askedBefore}
            number={before.number}
            isHeard={hand?.id === before.id}
            onFlip={flip}
            onSpot={playFrom}
          />
        )}
        {hand && (
          <WaveStage
            take={hand}
            name={`${cue.name}, ${nameOf(hand)}`}
            target={target}
            player={player}
            range={playing.range}
            comments={blind ? [] : marksOf(said, hand.id)}
            openComment={openSaid}
            hidden={blind !== null}
            small={isSet}
            onMark={(startAtS, id) => {
              player.seek(startAtS)
              if (!player.isPlaying()) void player.play(startAtS)
              if (said.some((one) => one.id === id)) setOpenSaid(id)
            }}
          />
        )}
        {hand && (
          <Transport
            player={player}
            playing={playing}
            durationS={soundOf(hand, target).durationS}
            silent={source === null ? whySilent(hand, target) : null}
            onNext={heard.length > 1 ? () => stepTake(1) : before ? flip : undefined}
            nextWords={before && current ? `${before.number} ⇄ ${current.number}` : nextWords(heard, hand, nameOf)}
            blind={canBlind ? { on: blind !== null, toggle: toggleBlind } : undefined}
            asGame={isSet && heard.length > 1 ? asGame : undefined}
            takeId={hand.id}
          />
        )}
        <div className={classes.verdict}>
          <Verdict
            review={review}
            money={props.money}
            hand={hand}
            meant={meant}
            name={blind && hand ? nameOf(hand) : meantName}
            whole={whole}
            waiting={waiting}
            judge={judge}
            range={playing.range}
            changing={changing}
            isPlaying={playing.status === 'playing'}
            onPlay={source === null ? null : () => void player.toggle()}
            onApprove={approve}
            onAcceptSet={acceptSet}
            onChange={openChange}
            onCloseChange={() => setChanging(null)}
            onChanged={(takes) => {
              setChanging(null)
              setPicked(new Set())
              const noted = new Set(takes.map(({ id }) => id))
              const next = waiting.find((take) => !noted.has(take.id) && take.draft_change === null)
              if (isSet && next) setHandId(next.id)
              else onJudged()
            }}
            onComment={() => write()}
            onWouldTake={wouldTake}
          />
        </div>
      </section>
      <SidePanel
        review={review}
        projectId={projectId}
        hand={hand}
        heard={heard}
        nameOf={nameOf}
        said={said}
        openSaid={openSaid}
        onOpen={goTo}
        onSpot={playFrom}
        writing={writing}
        onWrite={write}
        onWriting={setWriting}
        comment={comment}
        blind={blind !== null}
      />
    </>
  )
}

/** A place in the sound; its very start and end mean the whole of it. */
function inside(positionS: number, take: ReviewTake | undefined, target: string): number {
  if (take === undefined) return 0
  return positionS < soundOf(take, target).durationS ? positionS : 0
}

function whySilent(take: ReviewTake, target: string): string {
  const { refusal } = soundOf(take, target)
  return refusal ? `This game file does not exist: ${refusal}` : 'The preview is not ready yet.'
}

function nextWords(heard: readonly ReviewTake[], hand: ReviewTake, nameOf: (take: ReviewTake) => string): string {
  const at = heard.findIndex(({ id }) => id === hand.id)
  const next = heard[(at + 1) % heard.length]
  return next ? `${nameOf(hand)} ⇄ ${nameOf(next)}` : ''
}
