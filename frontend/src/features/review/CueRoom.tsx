import { useNavigate } from '@tanstack/react-router'
import { useEffect, useEffectEvent, useMemo, useState } from 'react'
import { flushSync } from 'react-dom'

import { showToast } from '@/app/toast'
import { CONDITIONS, type Player, type PlayerState, spotOf } from '@/audio'
import type { CueReview, ReviewTake } from '@/verdicts/api'
import { blockedWords, whyBlocked } from '@/verdicts/blocked'
import { isWholeSet, pickedOfSet } from '@/verdicts/choice'
import { FirstListen } from '@/verdicts/FirstListen'
import { AS_DELIVERED, inOrder, MASTER, soundOf, sourceOf, targetsOf, variationName } from '@/verdicts/hearing'
import { useLabelling } from '@/verdicts/labels'
import { matchedWords } from '@/verdicts/levels'
import { useReasons } from '@/verdicts/reasons'
import { playWhole, useFirstListen, withHeard } from '@/verdicts/useFirstListen'
import { type Placing, useHearing } from '@/verdicts/useHearing'
import type { Verdicts } from '@/verdicts/useVerdicts'
import { STATE_OF_TAKE } from '@/verdicts/stateOfTake'
import { usePreference } from '@/verdicts/usePreference'
import { capital, takeName } from '@/verdicts/words'
import type { CueMoney } from '@/money/api'
import { copyText } from '@/ui/copyText'
import { figure, shortDay } from '@/ui/format'
import { useLazy } from '@/ui/useLazy'

import { useComment } from './api'
import { Asked } from './Asked'
import { carriedMarks, carriedTo } from './carried'
import { CueHead } from './CueHead'
import { type MoreGroup, present } from './more'
import classes from './Review.module.css'
import { marksOf, type FeedbackItem, toFeedback } from './feedback'
import { SetRows } from './SetRows'
import { SetPlaybackPanel } from './LazySetPlaybackPanel'
import { SidePanel } from './SidePanel'
import { TakeCards } from './TakeCards'
import { Transport } from './Transport'
import { useCompared } from './useCompared'
import type { Conditions } from './useCondition'
import { inside, whySilent } from './soundInHand'
import { useRoomKeys } from './useRoomKeys'
import { useSetPlaybackMode } from './useSetPlaybackMode'
import { useTakesHeard } from './useTakesHeard'
import { useWriting } from './useWriting'
import { type Asking, Verdict } from './Verdict'
import { WaveStage } from './WaveStage'

const loadScene = () => import('./scene/SceneStage').then(({ SceneStage }) => SceneStage)
const loadCutForm = () => import('./CutForm').then(({ CutForm }) => CutForm)
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
  verdicts: Verdicts
  /** How many wait in the queue. */
  waiting: number | string
  onQueue: () => void
  onJudged: () => void
  startTakeId?: string
  startS?: number
  /** Play it as it opens: it follows a verdict, and this person wants the next one played. */
  playsAtOnce: boolean
  onPlayed: () => void
  playsNext: { on: boolean; toggle: () => void }
}

/** One cue on the stage, and at its side what was said and found. */
export function CueRoom(props: CueRoomProps) {
  const { heardHere, projectId, player, playing, target, onTarget, verdicts, onJudged } = props
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
  const [checkingOpen, setCheckingOpen] = useState(review.checklist.blocked.length > 0)
  const Checklist = useLazy(loadChecklist, checkingOpen, () => setCheckingOpen(false))
  const [cutting, setCutting] = useState(false)
  const CutForm = useLazy(loadCutForm, cutting, () => setCutting(false))
  const [hasStrips, setStrips] = usePreference('soundlist-review-strips', false)
  const navigate = useNavigate()
  const source = useHearing(player, cue.id, hand, target, gains, placing)
  /** Where the version begins in what is heard. */
  const firstS = placing?.startS ?? 0
  const targets = targetsOf(review.takes)

  const { startS } = props
  const playsNow = props.playsAtOnce && source !== null
  const playFirst = useEffectEvent(() => {
    props.onPlayed()
    void player.play(0)
  })
  useEffect(() => {
    if (playsNow) playFirst()
  }, [playsNow])
  useEffect(() => {
    if (startS !== undefined) player.seek(startS)
  }, [player, startS])

  const feedback = toFeedback(review, hand && heard.includes(hand) ? heard : hand ? [hand] : [])

  const numbered = feedback.filter(({ number }) => number !== null).length
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
    void verdicts.approve(cue, free, meantName, because)
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
    void verdicts.acceptSet(cue, waiting, toPick, because)
    onJudged()
  }
  const isCut = cue.state === 'cut'
  const canApprove = hand?.state === 'conforming' || hand?.state === 'set_aside'
  const canChange = hand?.state === 'conforming' || hand?.state === 'approved'
  const rights = {
    mayPick: review.may_approve && !isCut && (whole || canApprove),
    isBlocked: whole ? toPick.some(({ id }) => why.has(id)) : free.length === 0,
    mayAsk: review.may_approve && !isCut && canChange,
    mayPrefer: !review.may_approve && canApprove,
  }
  const approveUnheard = () => (whole ? acceptSet() : approve())
  const approveOnlyThis = (because?: readonly string[]) => listen.approveHeard(free, () => approve(because))
  const approveMeant = (because?: readonly string[]) => {
    if (whole) listen.approveHeard(toPick, () => acceptSet(because))
    else approveOnlyThis(because)
  }
  const openChange = () => {
    player.pause()
    verdicts.change.reset()
    setAsking(null)
    flushSync(() => setChanging({ positionS: inside(player.positionS() - firstS, hand, target) }))
  }
  const ask = (next: Asking) => {
    player.pause()
    verdicts.change.reset()
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
    if (verdicts.change.isPending) return
    const range = placing ? null : playing.range
    const atS = inside(player.positionS() - firstS, hand, target)
    const where = range ?? { startS: atS > 0 ? atS : undefined }
    verdicts.change.mutate(
      { cue, takes: meant, name: meantName, said: { note: `${reason}.`, reasons: [reason], ...where } },
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
  const prefer = () => {
    if (hand === undefined) return
    comment.mutate(
      { takeId: hand.id, text: `I prefer ${realName(hand)}.` },
      { onSuccess: () => showToast(`Comment sent: I prefer ${realName(hand)}.`) },
    )
  }
  const goTo = (item: FeedbackItem) => {
    setOpenSaid(item.id)
    const take = review.takes.find(({ id }) => id === item.takeId)
    if (take && take.id !== hand?.id) choose(take)
    if (item.startS !== null) playFrom(item.startS)
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
  const setWay = useSetPlaybackMode()
  const playRandomized = () =>
    void player.playRandomized(
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

  const versions = inOrder(review.takes).filter((take) => !isSet || take.variation === hand?.variation)
  const { condition, choose: hearAs } = props.conditions
  const mayHearScene = props.seesScene && blind === null
  const unheard = listen.unheard.length > 0
  const toggle = (next: Asking) => ask(asking === next ? null : next)
  const copyLink = async () => {
    if (hand === undefined) return
    const link = new URL(window.location.href)
    link.search = new URLSearchParams({ take: hand.id, at: player.positionS().toFixed(3) }).toString()
    const isCopied = await copyText(link.href, document.body)
    showToast(isCopied ? 'Link to this position copied.' : `Not copied. The link is ${link.href}`)
  }
  const more: MoreGroup[] = present<MoreGroup>([
    targets.length > 1 && {
      title: 'Listen to',
      isChoice: true,
      items: targets.map((name) => ({
        label: name === AS_DELIVERED ? 'Master as delivered' : capital(name),
        checked: name === target,
        run: () => onTarget(name),
      })),
    },
    {
      items: present([
        {
          label: 'Match levels',
          keys: 'm',
          checked: playing.matched,
          run: () => player.setMatched(!playing.matched),
        },
        { label: 'Spectrum and level', keys: 's', checked: hasStrips, run: () => setStrips(!hasStrips) },
        canBlind && {
          label: 'Hide version names',
          keys: 'd',
          keyLabel: 'Hide version names: compare blind',
          checked: blind !== null,
          run: toggleBlind,
        },
        mayHearScene && {
          label: 'Play in context',
          keys: 'o',
          keyLabel: 'Alone, or in its scene',
          checked: inScene,
          run: () => setInScene(!inScene),
        },
        {
          label: 'Play in reverse',
          keys: 'v',
          checked: playing.reversed,
          run: () => player.setReversed(!playing.reversed),
        },
        mayHearScene && {
          label: 'Against another sound',
          checked: comparing,
          run: () => setComparing(!comparing),
        },
        isSet &&
          heard.length > 1 && {
            label: 'Play randomised',
            note: 'hold h',
            checked: playing.isRandomized,
            run: () => (playing.isRandomized ? player.pause() : playRandomized()),
          },
        isSet &&
          heard.length > 1 && {
            label: 'How the set is played',
            keys: 'shift+h',
            keyLabel: 'How the set is played: rate, pitch, level',
            checked: setWay.isOpen,
            run: () => setWay.setOpen(!setWay.isOpen),
          },
        {
          label: 'Play the next sound after a verdict',
          checked: props.playsNext.on,
          run: props.playsNext.toggle,
        },
      ]),
    },
    {
      title: condition ? `Heard as: ${condition.name}` : 'Heard at full range',
      isChoice: true,
      isFolded: true,
      items: [
        { label: 'Full range', note: 'as delivered', checked: condition === null, run: () => hearAs(null) },
        ...CONDITIONS.map((option) => ({
          label: capital(option.name),
          note: option.figures,
          checked: option.id === condition?.id,
          run: () => hearAs(option),
        })),
      ],
    },
    review.takes.length > 0 &&
      blind === null && {
        title: hand ? `Version ${hand.number} of ${versions.length}` : 'Versions',
        isChoice: true,
        isFolded: true,
        items: versions.toReversed().map((take) => ({
          label: `Version ${take.number}, ${shortDay(take.received_at)}${isSet ? `, ${variationName(take.variation)}` : ''}`,
          note: STATE_OF_TAKE[take.state].replaceAll('_', ' '),
          checked: take.id === hand?.id,
          run: () => choose(take),
        })),
      },
    {
      items: present([
        review.may_approve &&
          canApprove && { label: `Prefer ${blind && hand ? nameOf(hand) : meantName}, as a comment`, run: prefer },
        rights.mayPick && {
          label: 'Approve with a reason',
          keys: 'p',
          keyLabel: 'Approve with a reason, then 1–9',
          disabled: rights.isBlocked,
          run: () => toggle('pick'),
        },
        rights.mayAsk && {
          label: 'Request a change for one reason',
          keys: 'shift+r',
          keyLabel: 'Request a change for one reason, then 1–9',
          run: () => toggle('change'),
        },
        whole &&
          rights.mayPick &&
          canApprove && {
            label: `Approve only ${meantName}`,
            keys: 'shift+a',
            keyLabel: 'Approve only this variation',
            disabled: free.length === 0,
            run: () => approveOnlyThis(),
          },
        review.checklist.items.length > 0 &&
          hand && {
            label: `Checklist, ${checkedOf(review, hand)} of ${review.checklist.items.length}`,
            keys: checkingOpen ? 'shift+i' : 'i',
            keyLabel: 'Open the checklist',
            run: () => setCheckingOpen(!checkingOpen),
          },
        hand &&
          blind === null && {
            label: 'Label',
            keys: 'shift+l',
            keyLabel: 'Label the version, then 1–9',
            disabled: changing !== null,
            run: () => toggle('label'),
          },
        hand && { label: `Copy link to ${figure(player.positionS(), 3)} s`, run: () => void copyLink() },
      ]),
    },
    (props.mayCut || (rights.mayPick && !rights.isBlocked && unheard)) && {
      items: present([
        props.mayCut && {
          label: 'Share with guests',
          run: () =>
            void navigate({ to: '/projects/$projectId/sharing', params: { projectId }, search: { cue: cue.id } }),
        },
        props.mayCut && !isCut && { label: 'Cut this cue', run: () => setCutting(true) },
        rights.mayPick && !rights.isBlocked && unheard && { label: 'Approve without listening', run: approveUnheard },
      ]),
    },
  ])

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
    playRandomized,
    player,
  })

  return (
    <>
      <section
        className={`flex flex-col bg-raised overflow-y-auto min-w-0 min-h-0 ${classes.stage}`}
        aria-label={cue.name}
      >
        <CueHead
          projectId={projectId}
          review={review}
          waitingHere={waiting.length > 0}
          queued={props.waiting}
          onQueue={props.onQueue}
        />
        {cutting && CutForm && (
          <CutForm
            cueId={cue.id}
            name={cue.name}
            projectId={projectId}
            onClose={() => setCutting(false)}
            onCut={onJudged}
          />
        )}
        {!isSet && heard.length > 1 && (
          <TakeCards
            takes={heard}
            handId={hand?.id}
            playingId={playing.status === 'playing' ? playing.takeId : null}
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
            projectId={projectId}
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
            comments={blind ? [] : [...marksOf(feedback, hand.id), ...carriedMarks(carried)]}
            openComment={openSaid}
            hidden={blind !== null}
            hasStrips={hasStrips}
            small={isSet}
            onMark={(startAtS, id) => {
              player.seek(startAtS)
              if (!player.isPlaying()) void player.play(startAtS)
              if (feedback.some((item) => item.id === id)) setOpenSaid(id)
            }}
          />
        )}
        {hand && (
          <Transport
            player={player}
            playing={playing}
            durationS={placing ? playing.durationS : soundOf(hand, target).durationS}
            isSilent={source === null}
            trouble={source === null ? whySilent(hand, target) : (playing.error ?? props.conditions.trouble)}
            onNext={heard.length > 1 ? () => stepTake(1) : before ? flip : undefined}
            says={present([
              target !== MASTER &&
                (target === AS_DELIVERED ? 'Hearing the master as delivered' : `Hearing the ${target} file`),
              condition && `Heard as: ${condition.name}`,
              playing.reversed && 'In reverse',
              blind === null &&
                playing.matched &&
                compared.length > 1 &&
                matchedWords(compared.map((take) => ({ name: nameOf(take), gainDb: gains.get(take.id) ?? 0 }))),
              source !== null && playing.durationS > 0 && playing.isLight && 'Preview',
            ])}
            more={more}
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
          <SetPlaybackPanel
            {...setWay}
            isPlaying={playing.isRandomized}
            onPlay={playRandomized}
            onStop={() => player.pause()}
          />
        )}
        <div className={`sticky bottom-0 flex-none ${classes.verdict}`}>
          <Verdict
            projectId={projectId}
            review={review}
            money={props.money}
            hand={hand}
            meant={meant}
            toPick={toPick}
            name={blind && hand ? nameOf(hand) : meantName}
            rights={rights}
            blockedSays={review.may_approve ? blockedWords(whole ? toPick : meant, why, blind ? nameOf : realName) : ''}
            checklist={
              checkingOpen && hand && Checklist && blind === null ? (
                <Checklist
                  key={hand.id}
                  checklist={review.checklist}
                  hand={hand}
                  cueId={cue.id}
                  onClose={() => setCheckingOpen(false)}
                />
              ) : null
            }
            whole={whole}
            waiting={waiting}
            verdicts={verdicts}
            range={placing ? null : playing.range}
            changing={changing}
            reasons={reasons}
            asking={asking}
            onAsking={ask}
            onChangeBecause={changeBecause}
            onLabel={labelAs}
            listening={
              listen.listening && {
                take: listen.listening,
                name: (blind ? nameOf : realName)(listen.listening),
                player,
                stop: listen.stop,
              }
            }
            notHeard={
              <FirstListen
                listen={listen}
                count={toPick.length}
                target={target}
                nameOf={blind ? nameOf : realName}
                button={whole ? 'Accept the set' : undefined}
                silent={source === null && hand ? whySilent(hand, target) : null}
              />
            }
            onApprove={approveMeant}
            onChange={openChange}
            onCloseChange={() => setChanging(null)}
            onChanged={changed}
            onComment={() => write()}
            onPrefer={prefer}
          />
        </div>
      </section>
      <SidePanel
        review={review}
        projectId={projectId}
        hand={hand}
        heard={heard}
        nameOf={nameOf}
        said={feedback}
        carried={carried}
        openSaid={openSaid}
        onOpen={goTo}
        onSpot={playFrom}
        writing={writing}
        onWriting={setWriting}
        comment={comment}
        blind={blind !== null}
      />
    </>
  )
}

/** How many items of the checklist were checked for a version. */
const checkedOf = ({ checklist }: CueReview, hand: ReviewTake): number =>
  checklist.checks.filter(({ take_id }) => take_id === hand.id).length
