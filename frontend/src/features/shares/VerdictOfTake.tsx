import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useMemo, useState } from 'react'
import { flushSync } from 'react-dom'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { HotkeyButton } from '@/app/keys'
import type { Player, PlayerState } from '@/audio'
import { reviewQuery } from '@/verdicts/api'
import { blockedWords, whyBlocked } from '@/verdicts/blocked'
import { ChangeForm } from '@/verdicts/ChangeForm'
import { FirstListen } from '@/verdicts/FirstListen'
import { MASTER } from '@/verdicts/hearing'
import { ReasonRow } from '@/verdicts/ReasonRow'
import { ReversalNote } from '@/verdicts/ReversalNote'
import { useReasons } from '@/verdicts/reasons'
import { useFirstListen, withHeard } from '@/verdicts/useFirstListen'
import { useVerdicts } from '@/verdicts/useVerdicts'
import { takeName } from '@/verdicts/words'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'

import type { PlaylistTake } from './api'

interface VerdictOfTakeProps {
  projectId: string
  playlistId: string
  take: PlaylistTake
  player: Player
  playing: PlayerState
  /** The takes that were heard on this page. */
  heardHere: ReadonlySet<string>
  /** Play the version from its start, for all of a session; null where another person plays. */
  onPlayFromStart: (() => void) | null
  /** It is heard before it is approved: another must not follow at its end. */
  onListen: () => void
  /** Whether the current person may open Review: the team does. */
  mayReview: boolean
  onJudged: () => void
}

const STATES: Record<PlaylistTake['state'], StateKind> = {
  received: 'checking',
  conforming: 'to_review',
  returned: 'returned',
  unjudged: 'unjudged',
  approved: 'approved',
  change_requested: 'change_requested',
  set_aside: 'set_aside',
}

function silentWords(take: PlaylistTake, mayPlay: boolean): string | null {
  if (take.preview_url === null) return 'The preview is not ready yet.'
  return mayPlay ? null : 'It is heard once the session plays it.'
}

/** The verdict on the sound that plays, by the keys of the review room, for who may give it. */
export function VerdictOfTake({
  projectId,
  playlistId,
  take,
  player,
  playing,
  heardHere,
  onPlayFromStart,
  onListen,
  mayReview,
  onJudged,
}: VerdictOfTakeProps) {
  const client = useQueryClient()
  const { data: review } = useQuery({ ...reviewQuery(take.cue_id), enabled: take.may_approve })
  const verdicts = useVerdicts(projectId)
  const [picking, setPicking] = useState(false)
  const reasons = useReasons(projectId)
  const [changing, setChanging] = useState<{ positionS: number } | null>(null)
  const judged = useMemo(
    () => withHeard(review?.takes ?? [], heardHere).find(({ id }) => id === take.take_id),
    [review, heardHere, take.take_id],
  )
  const mayApprove = take.may_approve && judged !== undefined
  const canApprove = judged?.state === 'conforming' || judged?.state === 'set_aside'
  const canChange = judged?.state === 'conforming' || judged?.state === 'approved'
  const name = review && judged ? takeName(judged, review.cue, review.takes) : ''
  const blocked =
    mayApprove && canApprove && review ? blockedWords([judged], whyBlocked(review.checklist.blocked), () => name) : ''
  const toApprove = judged && mayApprove && canApprove && blocked === '' ? [judged] : []
  const listen = useFirstListen({ player, playing, takes: toApprove, play: () => onPlayFromStart?.() })
  const approveNow = (because: readonly string[] = []) => {
    if (!judged || !review) return
    setPicking(false)
    void verdicts.approve(review.cue, [judged], name, because).then(done)
  }
  const approve = (because: readonly string[] = []) => {
    listen.approveHeard(toApprove, () => approveNow(because))
    if (listen.unheard.length > 0) onListen()
  }
  const done = () => {
    void invalidate(client, queryKeys.playlist(playlistId))
    onJudged()
  }
  return (
    <div className="grid grid-cols-1 gap-3">
      <Refusal {...verdicts.refusal} />
      {changing && judged && review && (
        <ChangeForm
          takeId={judged.id}
          what={`${review.cue.name} ${name}`}
          listed={reasons.change}
          positionS={changing.positionS}
          range={null}
          saving={verdicts.change.isPending}
          error={verdicts.change.error}
          reversal={
            judged.state === 'approved' && <ReversalNote cueId={review.cue.id} what={`${review.cue.name} ${name}`} />
          }
          onClose={() => setChanging(null)}
          onSave={(change, close) =>
            verdicts.change.mutate(
              { cue: review.cue, takes: [judged], name, said: change },
              {
                onSuccess: () => {
                  close()
                  setChanging(null)
                  done()
                },
              },
            )
          }
        />
      )}
      {picking && canApprove && review && blocked === '' && (
        <ReasonRow
          reasons={reasons.pick}
          title={`Approve ${review.cue.name} ${name} because`}
          onReason={(reason) => approve([reason])}
          onClose={() => setPicking(false)}
        />
      )}
      {blocked && <p className="small">{blocked}</p>}
      {toApprove.length > 0 && (
        <p className="small mid">
          <FirstListen
            listen={listen}
            count={1}
            target={MASTER}
            nameOf={() => name}
            silent={silentWords(take, onPlayFromStart !== null)}
            onApproveUnheard={() => approveNow()}
          />
        </p>
      )}
      <div className="row wrap">
        <StatusBadge kind={STATES[judged?.state ?? take.state]} />
        {mayApprove && canChange && (
          <HotkeyButton
            keys="r"
            keyLabel="Request a change"
            keyGroup="Playlist"
            icon="pencil"
            iconTone="change"
            onPress={() => {
              setPicking(false)
              setChanging({ positionS: player.positionS() })
            }}
          >
            Request a change
          </HotkeyButton>
        )}
        {mayApprove && canApprove && (
          <HotkeyButton
            keys="p"
            keyLabel="Approve with a reason, then 1–9"
            keyGroup="Playlist"
            pressed={picking}
            disabled={blocked !== ''}
            onPress={() => flushSync(() => setPicking(!picking))}
          >
            Reason
          </HotkeyButton>
        )}
        {mayApprove && canApprove && review && (
          <HotkeyButton
            keys="a"
            keyLabel="Approve"
            keyGroup="Playlist"
            icon="tick"
            disabled={blocked !== ''}
            onPress={() => approve()}
          >
            Approve
          </HotkeyButton>
        )}
        {mayReview && (
          <Link
            className="link"
            to="/projects/$projectId/review/$cueId"
            params={{ projectId, cueId: take.cue_id }}
            search={{ take: take.take_id }}
          >
            Open in Review
          </Link>
        )}
      </div>
    </div>
  )
}
