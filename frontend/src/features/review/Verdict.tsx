import type { ReactNode } from 'react'

import { HotkeyButton, useHotkeys } from '@/app/keys'
import type { TimeRange } from '@/audio'
import type { CueReview, ReviewCue, ReviewTake } from '@/judging/api'
import { ChangeForm } from '@/judging/ChangeForm'
import type { ReasonKind } from '@/judging/reasons'
import { ReasonRow } from '@/judging/ReasonRow'
import { ReversalNote } from '@/judging/ReversalNote'
import type { Judge } from '@/judging/useJudge'
import { namesOf, takeName } from '@/judging/words'
import type { CueMoney } from '@/money/api'
import { dueWithPick } from '@/money/words'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'
import { VerdictBar } from '@/ui/VerdictBar'

import classes from './Review.module.css'

/** What the digits are: reasons of an approval or of a change, labels, or none of them. */
export type Asking = 'pick' | 'change' | 'label' | null

interface VerdictProps {
  review: CueReview
  money: CueMoney | null
  hand: ReviewTake | undefined
  /** What a verdict is for: the current take, or the selected ones. */
  meant: readonly ReviewTake[]
  name: string
  /** What is open of those a verdict is for, and which of them can be approved. */
  blocked: { says: string; free: number; isSet: boolean }
  /** The checklist of the version, above the buttons. */
  checklist: ReactNode
  /** What an approval waits for, as long as a version was not heard. */
  notHeard: ReactNode
  /** What an approval takes: one version a variation. */
  toPick: readonly ReviewTake[]
  /** A whole set waits and can be accepted at once. */
  whole: boolean
  waiting: readonly ReviewTake[]
  judge: Judge
  range: TimeRange | null
  changing: { positionS: number } | null
  /** What the studio says most, on the digits. */
  reasons: Record<ReasonKind, readonly string[]>
  /** Which reasons are open. */
  asking: Asking
  onAsking: (asking: Asking) => void
  /** Note a change for one reason, at once. */
  onChangeBecause: (reason: string) => void
  /** Say what the current version is among alternates; null where versions are compared blind. */
  onLabel: ((label: string | null) => void) | null
  isPlaying: boolean
  /** Play or pause; null where there is nothing to hear. */
  onPlay: (() => void) | null
  onApprove: (because?: readonly string[]) => void
  onAcceptSet: (because?: readonly string[]) => void
  onChange: () => void
  onCloseChange: () => void
  onChanged: (takes: readonly ReviewTake[]) => void
  onComment: () => void
  onWouldTake: () => void
}

const STATE_WORDS: Partial<Record<ReviewTake['state'], string>> = {
  received: 'This version is being checked.',
  returned: 'This version was returned by the automatic check.',
  unjudged: 'The check of this version failed. That is our fault; no round is counted.',
  change_requested: 'A change was requested for this version.',
  set_aside: 'This version was set aside. You can still pick it.',
  approved: 'This version is approved.',
}

/** Who decides, what follows, and the buttons that do it. */
export function Verdict(props: VerdictProps) {
  const { review, hand, meant, name, whole, judge, changing, blocked, waiting } = props
  const { cue, may_approve } = review
  const state = hand?.state
  const canApprove = state === 'conforming' || state === 'set_aside'
  const canChange = state === 'conforming' || state === 'approved'
  const isSet = cue.variations > 1
  const isCut = cue.state === 'cut'
  const refusal = judge.refusal

  const mayPick = may_approve && !isCut && (whole || canApprove)
  const isBlocked = whole ? blocked.isSet : blocked.free === 0
  const mayAsk = may_approve && !isCut && canChange
  const isPicking = props.asking === 'pick' && mayPick && !isBlocked && !changing
  const { onLabel } = props
  const isLabelling = props.asking === 'label' && hand !== undefined && onLabel !== null && !changing
  const isAsking = props.asking === 'change' && mayAsk && !changing
  useHotkeys([
    {
      keys: 'shift+r',
      label: 'Request a change for one reason, then 1–9',
      group: 'Review',
      run: () => props.onAsking(props.asking === 'change' ? null : 'change'),
      disabled: !mayAsk,
    },
  ])

  const reversal = meant.some((take) => take.state === 'approved') && (
    <ReversalNote cueId={cue.id} what={`${cue.name} ${name}`} />
  )
  const above = (changing || refusal || isPicking || isAsking || isLabelling || props.checklist) && (
    <>
      {!changing && !isPicking && !isAsking && !isLabelling && props.checklist}
      {refusal && <ProblemNote detail={`${refusal.what} ${refusal.problem.detail}`} fix={refusal.problem.fix} />}
      {isPicking && (
        <ReasonRow
          reasons={props.reasons.pick}
          title={`Approve ${whole ? `the set of ${cue.variations}` : `${cue.name} ${name}`} because`}
          onReason={(reason) => (whole ? props.onAcceptSet([reason]) : props.onApprove([reason]))}
          onClose={() => props.onAsking(null)}
        />
      )}
      {isAsking && (
        <ReasonRow
          reasons={props.reasons.change}
          title={`Request a change of ${cue.name} ${name} because`}
          onReason={props.onChangeBecause}
          onClose={() => props.onAsking(null)}
        />
      )}
      {isAsking && reversal}
      {isLabelling && (
        <ReasonRow
          reasons={props.reasons.label}
          title={`Label ${takeName(hand, cue, waiting)}${hand.label === null ? '' : `, now “${hand.label}”,`} as`}
          onReason={onLabel}
          none={{ title: 'No label', run: () => onLabel(null) }}
          onClose={() => props.onAsking(null)}
        />
      )}
      {isAsking && judge.changeProblem && (
        <ProblemNote detail={judge.changeProblem.detail} fix={judge.changeProblem.fix} />
      )}
      {changing && (
        <ChangeForm
          takeId={meant[0]?.id ?? cue.id}
          what={`${cue.name} ${name}`}
          listed={props.reasons.change}
          positionS={changing.positionS}
          range={props.range}
          saving={judge.change.isPending}
          problem={judge.changeProblem}
          onClose={props.onCloseChange}
          reversal={reversal}
          onSave={(said, done) =>
            judge.change.mutate(
              { takes: meant, said },
              {
                onSuccess: () => {
                  done()
                  props.onChanged(meant)
                },
              },
            )
          }
        />
      )}
    </>
  )

  return (
    <VerdictBar
      who={whoDecides(review, props.money)}
      follows={
        <>
          {mayPick && !isBlocked && props.notHeard}{' '}
          {[blocked.says, follows(props), due(props)].filter(Boolean).join(' ')}
        </>
      }
      above={above}
      narrow={
        <Button
          icon={props.isPlaying ? 'pause' : 'play'}
          tall
          disabled={props.onPlay === null}
          onClick={() => props.onPlay?.()}
        >
          {props.isPlaying ? 'Pause' : 'Play'}
        </Button>
      }
    >
      {!whole && (
        <Button keys="c" icon="comment" tall className={classes.optional} onClick={props.onComment}>
          Comment
        </Button>
      )}
      {hand && onLabel && (
        <HotkeyButton
          keys="shift+l"
          keyLabel="Label the version, then 1–9"
          keyGroup="Review"
          tall
          pressed={isLabelling}
          disabled={changing !== null}
          onPress={() => props.onAsking(isLabelling ? null : 'label')}
        >
          Label
        </HotkeyButton>
      )}
      {mayAsk && (
        <HotkeyButton
          keys="r"
          keyLabel="Request a change"
          keyGroup="Review"
          icon="pencil"
          iconTone="change"
          tall
          onPress={props.onChange}
        >
          Request a change
        </HotkeyButton>
      )}
      {mayPick && (
        <HotkeyButton
          keys="p"
          keyLabel="Approve with a reason, then 1–9"
          keyGroup="Review"
          tall
          pressed={isPicking}
          disabled={isBlocked}
          onPress={() => props.onAsking(isPicking ? null : 'pick')}
        >
          Reason
        </HotkeyButton>
      )}
      {may_approve && !isCut && canApprove && isSet && (
        <HotkeyButton
          keys={whole ? 'shift+a' : 'a'}
          keyLabel={whole ? 'Approve only this variation' : 'Approve this variation'}
          keyGroup="Review"
          variant={whole ? 'plain' : 'primary'}
          icon={whole ? undefined : 'tick'}
          tall
          className={whole ? classes.optional : undefined}
          disabled={blocked.free === 0}
          onPress={() => props.onApprove()}
        >
          Approve {name}
        </HotkeyButton>
      )}
      {may_approve && !isCut && whole && (
        <HotkeyButton
          keys="a"
          keyLabel="Accept the set"
          keyGroup="Review"
          variant="primary"
          icon="tick"
          tall
          disabled={blocked.isSet}
          onPress={() => props.onAcceptSet()}
        >
          Accept the set
        </HotkeyButton>
      )}
      {may_approve && !isCut && canApprove && !isSet && (
        <HotkeyButton
          keys="a"
          keyLabel="Approve"
          keyGroup="Review"
          variant="primary"
          icon="tick"
          tall
          disabled={blocked.free === 0}
          onPress={() => props.onApprove()}
        >
          Approve {name}
        </HotkeyButton>
      )}
      {!may_approve && canApprove && (
        <HotkeyButton
          keys="a"
          keyLabel="Say which one you’d pick"
          keyGroup="Review"
          variant="primary"
          tall
          onPress={props.onWouldTake}
        >
          I’d pick {name}
        </HotkeyButton>
      )}
    </VerdictBar>
  )
}

function whoDecides(review: CueReview, money: CueMoney | null): string {
  const { may_approve, approver, deputies, on_behalf_of: absent, rounds } = review
  if (!may_approve) {
    const names = [approver, ...deputies].map(({ name }) => name)
    return `You can comment. ${names.join(' or ')} approves.`
  }
  const counted = rounds.filter(({ number }) => number !== null).length
  const call = absent ? `Your call, for ${absent.name}.` : 'Your call.'
  if (money) return `${call} Revision round ${counted} of ${money.rounds_included}.`
  return `${call} ${counted === 0 ? 'No revision round yet.' : `${plural(counted, 'revision round')} so far.`}`
}

/** Versions of one variation that came in one delivery and between which nobody chose: no set is approved with them. */
function undecidedOf({ whole, waiting, toPick }: VerdictProps): ReviewTake[] {
  if (!whole) return []
  const picked = new Set(toPick.map(({ variation }) => variation))
  return waiting.filter((take) => take.undecided_with.length > 0 && !picked.has(take.variation))
}

/** Of a variation with several versions, which one the set takes and which give way: nobody chooses unawares. */
function takenWords(cue: ReviewCue, waiting: readonly ReviewTake[], toPick: readonly ReviewTake[]): string {
  const pickedIds = new Set(toPick.map(({ id }) => id))
  const picked = new Set(toPick.map(({ variation }) => variation))
  const others = waiting.filter(({ id, variation }) => picked.has(variation) && !pickedIds.has(id))
  if (others.length === 0) return ''
  const taken = toPick.filter(({ variation }) => others.some((other) => other.variation === variation))
  const named = (takes: readonly ReviewTake[]) => namesOf(takes.map((take) => takeName(take, cue, waiting)))
  return `Takes ${named(taken)}; ${named(others)} ${others.length === 1 ? 'is' : 'are'} set aside.`
}

function follows(props: VerdictProps): string {
  const { review, hand, meant, toPick, waiting, whole } = props
  const { cue } = review
  if (cue.state === 'cut') return 'This cue was cut.'
  if (hand === undefined) return 'No version yet.'
  const draft = hand.draft_change
  if (draft) return `Draft, not sent: “${draft.text}”`
  if (hand.state !== 'conforming') return STATE_WORDS[hand.state] ?? ''
  if (!review.may_approve) return ''
  if (whole) {
    const undecided = undecidedOf(props).map((take) => takeName(take, cue, waiting))
    if (undecided.length > 0) {
      return `Choose first: ${namesOf(undecided)} came in one delivery for the same sound, and nobody chose.`
    }
    const left = new Set(waiting.map(({ variation }) => variation)).size
    const all =
      left === cue.variations
        ? `Approves all ${cue.variations} variations at once.`
        : `Approves the ${plural(left, 'variation')} that ${left === 1 ? 'is' : 'are'} left.`
    return [all, takenWords(cue, waiting, toPick)].filter(Boolean).join(' ')
  }
  if (cue.variations > 1) {
    const missing = cue.variations - new Set(waiting.map(({ variation }) => variation)).size
    const left = missing - review.approved_variations.length
    return left > 0 ? `${plural(left, 'variation')} of the set ${left === 1 ? 'is' : 'are'} missing.` : ''
  }
  const others = waiting.filter((take) => !meant.includes(take))
  return others.length > 0
    ? `${cue.name} is accepted with it. The ${others.length === 1 ? 'other is' : 'others are'} kept.`
    : `${namesOf([cue.name])} is accepted with it.`
}

/** What picking the current version makes due, where it is the pick that accepts the cue. */
function due(props: VerdictProps): string {
  const { cue } = props.review
  const { money, hand, whole } = props
  if (undecidedOf(props).length > 0) return ''
  if (money === null || cue.state === 'cut' || hand === undefined || hand.draft_change) return ''
  const canApprove = hand.state === 'conforming' || hand.state === 'set_aside'
  return canApprove && (whole || cue.variations === 1) ? dueWithPick(money) : ''
}
