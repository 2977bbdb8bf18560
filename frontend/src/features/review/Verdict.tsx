import type { ReactNode } from 'react'

import { HotkeyButton } from '@/app/keys'
import type { Player, TimeRange } from '@/audio'
import type { CueReview, ReviewCue, ReviewTake } from '@/verdicts/api'
import { ChangeForm } from '@/verdicts/ChangeForm'
import type { ReasonKind } from '@/verdicts/reasons'
import { ReasonRow } from '@/verdicts/ReasonRow'
import { ReversalNote } from '@/verdicts/ReversalNote'
import type { Verdicts } from '@/verdicts/useVerdicts'
import { namesOf, takeName } from '@/verdicts/words'
import type { CueMoney } from '@/money/api'
import { dueWithPick } from '@/money/words'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { VerdictBar } from '@/ui/VerdictBar'

import { ListenProgress } from './ListenProgress'

/** What the digits are: reasons of an approval or of a change, labels, or none of them. */
export type Asking = 'pick' | 'change' | 'label' | null

/** What can be decided now, and of what. */
export interface Rights {
  /** The approver may pick what is in hand, or the set. */
  mayPick: boolean
  /** Something open stops it. */
  isBlocked: boolean
  /** The approver may request a change of it. */
  mayAsk: boolean
  /** An adviser says which one they prefer. */
  mayPrefer: boolean
}

interface VerdictProps {
  projectId: string
  review: CueReview
  money: CueMoney | null
  hand: ReviewTake | undefined
  /** What a verdict is for: the current take, or the selected ones. */
  meant: readonly ReviewTake[]
  name: string
  rights: Rights
  /** What is open of those a verdict is for. */
  blockedSays: string
  /** The checklist of the version, once it is opened. */
  checklist: ReactNode
  /** What an approval waits for, as long as a version was not heard. */
  notHeard: ReactNode
  /** The version that plays for the first time, because its approval was asked for, and how to stop it. */
  listening: { take: ReviewTake; name: string; player: Player; stop: () => void } | null
  /** What an approval takes: one version a variation. */
  toPick: readonly ReviewTake[]
  /** A whole set waits and can be accepted at once. */
  whole: boolean
  waiting: readonly ReviewTake[]
  verdicts: Verdicts
  range: TimeRange | null
  changing: { positionS: number } | null
  /** What the studio says most, on the digits. */
  reasons: Record<ReasonKind, readonly string[]>
  /** Which reasons are open. */
  asking: Asking
  onAsking: (asking: Asking) => void
  /** Request a change for one reason, at once. */
  onChangeBecause: (reason: string) => void
  onLabel: (label: string | null) => void
  onApprove: (because?: readonly string[]) => void
  onChange: () => void
  onCloseChange: () => void
  onChanged: (takes: readonly ReviewTake[]) => void
  onComment: () => void
  onPrefer: () => void
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
  const { review, hand, meant, name, whole, verdicts, changing, waiting, rights, listening } = props
  const { cue } = review
  const { refusal } = verdicts
  const asking = changing ? null : props.asking
  const label = `${cue.name} ${name}`
  const isOpen = changing !== null || asking !== null

  const reversal = meant.some((take) => take.state === 'approved') && <ReversalNote cueId={cue.id} what={label} />
  const above = (isOpen || refusal || props.checklist) && (
    <>
      {!isOpen && props.checklist}
      <Refusal {...refusal} />
      {asking === 'pick' && (
        <ReasonRow
          reasons={props.reasons.pick}
          title={`Approve ${whole ? `the set of ${cue.variations}` : label} because`}
          onReason={(reason) => props.onApprove([reason])}
          onClose={() => props.onAsking(null)}
        />
      )}
      {asking === 'change' && (
        <>
          <ReasonRow
            reasons={props.reasons.change}
            title={`Request a change of ${label} because`}
            onReason={props.onChangeBecause}
            onClose={() => props.onAsking(null)}
          />
          {reversal}
          <Refusal error={verdicts.change.error} />
        </>
      )}
      {asking === 'label' && hand && (
        <ReasonRow
          reasons={props.reasons.label}
          title={`Label ${takeName(hand, cue, waiting)}${hand.label === null ? '' : `, now “${hand.label}”,`} as`}
          onReason={props.onLabel}
          none={{ title: 'No label', run: () => props.onLabel(null) }}
          onClose={() => props.onAsking(null)}
        />
      )}
      {changing && (
        <ChangeForm
          takeId={meant[0]?.id ?? cue.id}
          projectId={props.projectId}
          what={label}
          to={hand?.designer.name}
          counts={roundWords(review, props.money, meant)}
          listed={props.reasons.change}
          positionS={changing.positionS}
          range={props.range}
          saving={verdicts.change.isPending}
          error={verdicts.change.error}
          onClose={props.onCloseChange}
          reversal={reversal}
          onSave={(change, done) =>
            verdicts.change.mutate(
              { cue, takes: meant, name, said: change },
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
  if (changing) return <VerdictBar above={above} />

  return (
    <VerdictBar
      who={
        listening
          ? `${listening.name} is playing for the first time. It is not approved yet.`
          : whoDecides(review, props.money)
      }
      follows={
        <>
          {rights.mayPick && !rights.isBlocked && props.notHeard}{' '}
          {!listening && [props.blockedSays, follows(props), due(props)].filter(Boolean).join(' ')}
        </>
      }
      above={above}
    >
      {listening ? (
        <Button keys="Escape" icon="cross" tall onClick={listening.stop}>
          Stop
        </Button>
      ) : (
        <Button keys="c" icon="comment" tall onClick={props.onComment}>
          Comment
        </Button>
      )}
      {rights.mayAsk && (
        <HotkeyButton
          keys="r"
          keyLabel="Request a change"
          keyGroup="Review"
          icon="pencil"
          iconTone="change"
          tall
          onPress={props.onChange}
        >
          Request change
        </HotkeyButton>
      )}
      {rights.mayPick && (
        <HotkeyButton
          keys="a"
          keyLabel={whole ? 'Accept the set' : 'Approve'}
          keyGroup="Review"
          variant={listening ? 'plain' : 'primary'}
          icon="tick"
          tall
          disabled={rights.isBlocked}
          onPress={() => props.onApprove()}
        >
          {whole ? 'Accept the set' : `Approve ${name}`}
          {listening && <ListenProgress {...listening} />}
        </HotkeyButton>
      )}
      {rights.mayPrefer && (
        <HotkeyButton
          keys="a"
          keyLabel="Say which one you prefer"
          keyGroup="Review"
          variant="primary"
          tall
          onPress={props.onPrefer}
        >
          Prefer {name}
        </HotkeyButton>
      )}
    </VerdictBar>
  )
}

/** What a change request counts. */
function roundWords({ rounds }: CueReview, money: CueMoney | null, meant: readonly ReviewTake[]): string {
  if (meant.some(({ state }) => state === 'approved')) return 'It counts no round.'
  const next = rounds.filter(({ number }) => number !== null).length + 1
  return money ? `Round ${next} of ${money.rounds_included}.` : `Round ${next}.`
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
  if (draft) return `${draft.sends_at === null ? 'Draft, not sent' : 'Change requested'}: “${draft.text}”`
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
