import { useEffect, useMemo, useState } from 'react'
import { flushSync } from 'react-dom'

import { showToast } from '@/app/toast'
import { type Player, type PlayerState, spotOf } from '@/audio'
import type { CueReview, ReviewTake } from '@/judging/api'
import { blockedWords, whyBlocked } from '@/judging/blocked'
import { isWholeSet, pickedOfSet } from '@/judging/choice'
import { FirstListen } from '@/judging/FirstListen'
import { soundOf, sourceOf, targetsOf } from '@/judging/hearing'
import { useLabelling } from '@/judging/labels'
import { matchedWords } from '@/judging/levels'
import { useReasons } from '@/judging/reasons'
import { playWhole, useFirstListen, withHeard } from '@/judging/useFirstListen'
import { type Placing, useHearing } from '@/judging/useHearing'
import type { Judge } from '@/judging/useJudge'
import { takeName } from '@/judging/words'
import type { CueMoney } from '@/money/api'
import { useLazy } from '@/ui/useLazy'

import { useComment } from './api'
import { Asked } from './Asked'
import { carriedMarks, carriedTo } from './carried'
import { CueHead } from './CueHead'
import classes from './Review.module.css'
import { marksOf, type Said, saidOf } from './said'
import { SetRows } from './SetRows'
import { SetWayButton, SetWayPanel } from './SetWay'
import { SidePanel } from './SidePanel'
import { TakeCards } from './TakeCards'
import { Transport } from './Transport'
import { useCompared } from './useCompared'
import type { Conditions } from './useCondition'
import { inside, nextWords, whySilent } from './soundInHand'
import { useRoomKeys } from './useRoomKeys'
import { useSetWay } from './useSetWay'
import { useTakesHeard } from './useTakesHeard'
import { useWriting } from './useWriting'
import { type Asking, Verdict } from './Verdict'
import { WaveStage } from './WaveStage'

const loadScene = () => import('./scene/SceneStage').then(({ SceneStage }) => SceneStage)
const loadChecklist = () => import('./Checklist').then(({ Checklist }) => Checklist)
const loadAgainst = () => import('./scene/AgainstPanel').then(({ AgainstPanel }) => AgainstPanel)

interface CueRoomProps {
  review: CueReview
  /** What its contract says of the cue; null where there is none, or the reader has no sight of money. */
  money: CueMoney | null
  projectId: string
  mayCut: boolean
  /** Of the team: other designers' sounds are in the scene. */
  seesScene: boolean
  player: Player
  playing: PlayerState
  /** The takes that were heard on this page. */
  heardHere: ReadonlySet<string>
  conditions: Conditions
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

/** One cue on the stage, and at its side what was said and found. */
export function CueRoom(props: CueRoomProps) {
  const { heardHere, projectId, player, playing, target, onTarget, judge, onJudged } = props
  const review = useMemo(
    () => ({ ...props.review, takes: withHeard(props.review.takes, heardHere) }),
    [props.review, heardHere],
  )
  const { cue } = review
  const takes = useTakesHeard(review, props.startTakeId)
  const { waiting, heard, hand, isSet, chosen, before, current, flip, choose, stepTake, picked, pick, blind, nameOf } =
    takes
  const [changing, setChanging] = useState<{ positionS: number } | null>(null)
  const [asking, setAsking] = useState<Asking>(null)
  const reasons = useReasons(projectId)
  const { writing, setWriting, begin } = useWriting(cue.id)
  const [openSaid, setOpenSaid] = useState<string>()
  const comment = useComment(cue.id)
  const labelling = useLabelling()

  const askedBefore = review.change_requests.filter(
    ({ take_id, sent_at }) => take_id === before?.id && sent_at !== null,
  )
  const { compared, gains, sources } = useCompared(heard, before, hand, target)
  const [inScene, setInScene] = useState(false)
  const [placing, setPlacing] = useState<Placing | null>(null)
  const [comparing, setComparing] = useState(false)
  const AgainstPanel = useLazy(loadAgainst, comparing, () => setComparing(false))
  const SceneStage = useLazy(loadScene, inScene, () => setInScene(false))
  const Checklist = useLazy(loadChecklist, review.checklist.items.length > 0)
  const source = useHearing(player, cue.id, hand, target, gains, placing)
  /** Where the version begins in what is heard. */
  const firstS = placing?.startS ?? 0
  const targets = targetsOf(review.takes)

  const { startS } = props
  useEffect(() => {
    if (startS !== undefined) player.seek(startS)
  }, [player, startS])

  const said = saidOf(review, hand && heard.includes(hand) ? heard : hand ? [hand] : [])

  const numbered = said.filter(({ number }) => number !== null).length
  const carried = hand ? carriedTo(review.carried_notes, hand, soundOf(hand, target).durationS, numbered) : []

  const meant = picked.size > 0 ? heard.filter(({ id }) => picked.has(id)) : hand ? [hand] : []
  const realName = (take: ReviewTake) => takeName(take, cue, waiting)
  const why = whyBlocked(review.checklist.blocked)
  const free = meant.filter(({ id, state }) => !why.has(id) && state !== 'approved')
  const toApprove = free.length > 0 ? free : meant
  const meantName = toApprove.length > 1 ? `${toApprove.length} variations` : toApprove.map(realName).join('')
  const whole = isWholeSet(cue, waiting, review.approved_variations)

  const leaves = (takes: readonly ReviewTake[]) => {
    const variations = new Set(takes.map(({ variation }) => variation))
    return waiting.every((take) => variations.has(take.variation) || take.draft_change !== null)
  }
  const toPick = whole ? pickedOfSet(waiting, chosen) : free
  const listen = useFirstListen({
    player,
    playing,
    takes: toPick,
    play: (take) => {
      const toPlay = take.id === hand?.id ? source : sourceOf(take, target, gains)
      choose(take)
      if (toPlay) playWhole(player, toPlay)
    },
  })
  const approve = (because: readonly string[] = []) => {
    if (free.length === 0) return
    player.pause()
    setAsking(null)
    const last = leaves(free)
    void judge.approve(cue, free, meantName, because)
    takes.showNames()
    takes.unpick()
    if (last) onJudged()
    else {
      const decided = new Set(free.map(({ variation }) => variation))
      takes.moveOn(({ variation }) => decided.has(variation))
    }
  }
  const acceptSet = (because: readonly string[] = []) => {
    player.pause()
    setAsking(null)
    void judge.acceptSet(cue, waiting, toPick, because)
    onJudged()
  }
  const blocked = {
    says: review.may_approve ? blockedWords(whole ? toPick : meant, why, blind ? nameOf : realName) : '',
    free: free.length,
    isSet: whole && toPick.some(({ id }) => why.has(id)),
  }
  const openChange = () => {
    player.pause()
    judge.change.reset()
    setAsking(null)
    flushSync(() => setChanging({ positionS: inside(player.positionS() - firstS, hand, target) }))
  }
  const ask = (next: Asking) => {
    player.pause()
    judge.change.reset()
    flushSync(() => setAsking(next))
  }
  const changed = (takesChanged: readonly ReviewTake[]) => {
    setChanging(null)
    setAsking(null)
    takes.unpick()
    const noted = new Set(takesChanged.map(({ id }) => id))
    if (!isSet || !takes.moveOn(({ id }) => noted.has(id))) onJudged()
  }
  const changeBecause = (reason: string) => {
    if (judge.change.isPending) return
    const range = placing ? null : playing.range
    const atS = inside(player.positionS() - firstS, hand, target)
    const where = range ?? { startS: atS > 0 ? atS : undefined }
    judge.change.mutate(
      { takes: meant, said: { note: `${reason}.`, reasons: [reason], ...where } },
      { onSuccess: () => changed(meant) },
    )
  }
  const labelAs = (words: string | null) => {
    if (hand) labelling(hand, `${cue.name} ${realName(hand)}`, words, () => setAsking(null))
  }
  const write = (text = '') => {
    if (hand === undefined) return
    const range = placing ? null : playing.range
    begin(text, range?.startS ?? inside(player.positionS() - firstS, hand, target), range?.endS)
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
    const atS = firstS + spotOf(startAtS)
    player.seek(atS)
    if (!player.isPlaying()) void player.play(atS)
  }
  const toggleBlind = () => {
    player.pause()
    setInScene(false)
    takes.toggleBlind()
  }
  const setWay = useSetWay()
  const asGame = () =>
    void player.playAsGame(
      heard.flatMap((take) => sourceOf(take, target, gains) ?? []),
      setWay.way,
    )
  const setEnd = (end: 'startS' | 'endS') => {
    if (hand === undefined) return
    const { durationS } = soundOf(hand, target)
    const now = playing.range ?? { startS: 0, endS: durationS }
    player.setRange({ ...now, [end]: player.positionS() })
  }
  const canBlind = !isSet && waiting.length > 1

  useRoomKeys({
    heard,
    isSet,
    asking: asking !== null,
    choose,
    pick,
    setEnd,
    targets,
    target,
    onTarget,
    write,
    asGame,
    player,
  })

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
          <TakeCards
            takes={heard}
            gains={gains}
            handId={hand?.id}
            nameOf={nameOf}
            blind={blind !== null}
            onChoose={choose}
          />
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
        {hand && !(SceneStage && inScene) && (
          <WaveStage
            take={hand}
            name={`${cue.name}, ${nameOf(hand)}`}
            target={target}
            player={player}
            range={playing.range}
            comments={blind ? [] : [...marksOf(said, hand.id), ...carriedMarks(carried)]}
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
            durationS={placing ? playing.durationS : soundOf(hand, target).durationS}
            silent={source === null ? whySilent(hand, target) : null}
            onNext={heard.length > 1 ? () => stepTake(1) : before ? flip : undefined}
            nextWords={before && current ? `${before.number} ⇄ ${current.number}` : nextWords(heard, hand, nameOf)}
            matchedSays={
              blind
                ? ''
                : matchedWords(compared.map((take) => ({ name: nameOf(take), gainDb: gains.get(take.id) ?? 0 })))
            }
            conditions={props.conditions}
            blind={canBlind ? { on: blind !== null, toggle: toggleBlind } : undefined}
            asGame={isSet && heard.length > 1 ? { play: asGame, way: <SetWayButton {...setWay} /> } : undefined}
            scene={
              props.seesScene && blind === null
                ? {
                    on: inScene,
                    toggle: () => setInScene(!inScene),
                    compares: comparing,
                    compare: () => setComparing(!comparing),
                  }
                : undefined
            }
            takeId={hand.id}
          />
        )}
        {hand && AgainstPanel && comparing && blind === null && (
          <AgainstPanel
            key={hand.id}
            review={review}
            projectId={projectId}
            hand={hand}
            nameOf={nameOf}
            source={source}
            player={player}
            playing={playing}
          />
        )}
        {hand && SceneStage && inScene && (
          <SceneStage
            takeId={hand.id}
            projectId={projectId}
            player={player}
            looping={playing.looping}
            sources={sources}
            matched={playing.matched}
            onPlacing={setPlacing}
          />
        )}
        {isSet && heard.length > 1 && (
          <SetWayPanel {...setWay} isPlaying={playing.asGame} onPlay={asGame} onStop={() => player.pause()} />
        )}
        <div className={classes.verdict}>
          <Verdict
            review={review}
            money={props.money}
            hand={hand}
            meant={meant}
            toPick={toPick}
            name={blind && hand ? nameOf(hand) : meantName}
            blocked={blocked}
            checklist={
              hand && Checklist && blind === null ? (
                <Checklist key={hand.id} checklist={review.checklist} hand={hand} cueId={cue.id} />
              ) : null
            }
            whole={whole}
            waiting={waiting}
            judge={judge}
            range={placing ? null : playing.range}
            changing={changing}
            reasons={reasons}
            asking={asking}
            onAsking={ask}
            onChangeBecause={changeBecause}
            onLabel={blind === null ? labelAs : null}
            isPlaying={playing.status === 'playing'}
            onPlay={source === null ? null : () => void player.toggle()}
            notHeard={
              <FirstListen
                listen={listen}
                count={toPick.length}
                target={target}
                nameOf={blind ? nameOf : realName}
                silent={source === null && hand ? whySilent(hand, target) : null}
                onApproveUnheard={() => (whole ? acceptSet() : approve())}
              />
            }
            onApprove={(because) => listen.approveHeard(free, () => approve(because))}
            onAcceptSet={(because) => listen.approveHeard(toPick, () => acceptSet(because))}
            onChange={openChange}
            onCloseChange={() => setChanging(null)}
            onChanged={changed}
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
        carried={carried}
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
