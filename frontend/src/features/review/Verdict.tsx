import { HotkeyButton } from '@/app/keys'
import type { TimeRange } from '@/audio'
import type { CueReview, ReviewTake } from '@/judging/api'
import { ChangeForm } from '@/judging/ChangeForm'
import type { Judge } from '@/judging/useJudge'
import { namesOf } from '@/judging/words'
import type { CueMoney } from '@/money/api'
import { dueWithPick } from '@/money/words'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'
import { VerdictBar } from '@/ui/VerdictBar'

import classes from './Review.module.css'

interface VerdictProps {
  review: CueReview
  money: CueMoney | null
  hand: ReviewTake | undefined
  /** What a verdict is for: the take in the hand, or the selected ones. */
  meant: readonly ReviewTake[]
  name: string
  /** A whole set waits and can be accepted at once. */
  whole: boolean
  waiting: readonly ReviewTake[]
  judge: Judge
  range: TimeRange | null
  changing: { positionS: number } | null
  onApprove: () => void
  onAcceptSet: () => void
  onChange: () => void
  onCloseChange: () => void
  onChanged: (takes: readonly ReviewTake[]) => void
  onComment: () => void
  onWouldTake: () => void
}

const STATE_WORDS: Partial<Record<ReviewTake['state'], string>> = {
  received: 'This version is being checked.',
  returned: 'This version was returned by the checker.',
  unjudged: 'The check of this version broke. That is our fault; no round counts.',
  change_requested: 'This version went back with a change request.',
  set_aside: 'This version was set aside; it can still be picked.',
  approved: 'This version is approved.',
}

/** Who decides, what follows, and the buttons that do it. */
export function Verdict(props: VerdictProps) {
  const { review, hand, meant, name, whole, judge, changing } = props
  const { cue, may_decide } = review
  const state = hand?.state
  const canApprove = state === 'conforming' || state === 'set_aside'
  const canChange = state === 'conforming' || state === 'approved'
  const isSet = cue.variations > 1
  const isCut = cue.state === 'cut'
  const refusal = judge.refusal

  const above = (changing || refusal) && (
    <>
      {refusal && <ProblemNote detail={`${refusal.what} ${refusal.problem.detail}`} fix={refusal.problem.fix} />}
      {changing && (
        <ChangeForm
          what={`${cue.name} ${name}`}
          positionS={changing.positionS}
          range={props.range}
          saving={judge.change.isPending}
          problem={judge.changeProblem}
          onClose={props.onCloseChange}
          onSave={(said) => judge.change.mutate({ takes: meant, said }, { onSuccess: () => props.onChanged(meant) })}
        />
      )}
    </>
  )

  return (
    <VerdictBar who={whoDecides(review)} follows={[follows(props), due(props)].filter(Boolean).join(' ')} above={above}>
      {!whole && (
        <Button keys="c" icon="comment" tall className={classes.optional} onClick={props.onComment}>
          Comment
        </Button>
      )}
      {may_decide && !isCut && canChange && (
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
      {may_decide && !isCut && canApprove && isSet && (
        <HotkeyButton
          keys={whole ? 'shift+a' : 'a'}
          keyLabel={whole ? 'Approve the variation alone' : 'Approve the variation'}
          keyGroup="Review"
          variant={whole ? 'plain' : 'primary'}
          icon={whole ? undefined : 'tick'}
          tall
          className={whole ? classes.optional : undefined}
          onPress={props.onApprove}
        >
          Approve {name}
        </HotkeyButton>
      )}
      {may_decide && !isCut && whole && (
        <HotkeyButton
          keys="a"
          keyLabel="Accept the set"
          keyGroup="Review"
          variant="primary"
          icon="tick"
          tall
          onPress={props.onAcceptSet}
        >
          Accept the set
        </HotkeyButton>
      )}
      {may_decide && !isCut && canApprove && !isSet && (
        <HotkeyButton
          keys="a"
          keyLabel="Approve"
          keyGroup="Review"
          variant="primary"
          icon="tick"
          tall
          onPress={props.onApprove}
        >
          Approve {name}
        </HotkeyButton>
      )}
      {!may_decide && canApprove && (
        <HotkeyButton
          keys="a"
          keyLabel="Say which you would take"
          keyGroup="Review"
          variant="primary"
          tall
          onPress={props.onWouldTake}
        >
          I would take {name}
        </HotkeyButton>
      )}
    </VerdictBar>
  )
}

function whoDecides({ may_decide, decider, rounds }: CueReview): string {
  if (!may_decide) return `You advise. ${decider.name} decides.`
  const counted = rounds.filter(({ number }) => number !== null).length
  return `You decide. ${counted === 0 ? 'No round yet.' : `${plural(counted, 'round')} so far.`}`
}

function follows({ review, hand, meant, waiting, whole }: VerdictProps): string {
  const { cue } = review
  if (cue.state === 'cut') return 'The game no longer needs this cue.'
  if (hand === undefined) return 'No version was delivered yet.'
  const draft = hand.draft_change
  if (draft) return `Noted, not sent: “${draft.text}”`
  if (hand.state !== 'conforming') return STATE_WORDS[hand.state] ?? ''
  if (!review.may_decide) return ''
  if (whole) return `All ${cue.variations} are approved at once.`
  if (cue.variations > 1) {
    const missing = cue.variations - new Set(waiting.map(({ variation }) => variation)).size
    const left = missing - review.approved_variations.length
    return left > 0 ? `${plural(left, 'variation')} of the set ${left === 1 ? 'is' : 'are'} still to come.` : ''
  }
  const others = waiting.filter((take) => !meant.includes(take))
  return others.length > 0
    ? `${cue.name} is accepted with it. The ${others.length === 1 ? 'other is' : 'others are'} kept.`
    : `${namesOf([cue.name])} is accepted with it.`
}

/** What picking the version in the hand makes due, where it is the pick that accepts the cue. */
function due({ review: { cue }, money, hand, whole }: VerdictProps): string {
  if (money === null || cue.state === 'cut' || hand === undefined || hand.draft_change) return ''
  const canApprove = hand.state === 'conforming' || hand.state === 'set_aside'
  return canApprove && (whole || cue.variations === 1) ? dueWithPick(money) : ''
}
