import { useMediaQuery } from '@mantine/hooks'
import { Link, useNavigate } from '@tanstack/react-router'
import { useMemo, useState } from 'react'
import { flushSync } from 'react-dom'

import { HotkeyButton, useHotkeys } from '@/app/keys'
import { type Player, type PlayerState, TakeCard, Waveform } from '@/audio'
import { type QueueItem, type ReviewTake } from '@/verdicts/api'
import { blockedWords, whyBlocked } from '@/verdicts/blocked'
import { ChangeForm } from '@/verdicts/ChangeForm'
import { isWholeSet, pickedOfSet } from '@/verdicts/choice'
import { FirstListen } from '@/verdicts/FirstListen'
import { type Gains, MASTER, matchGains, soundOf, sourceOf } from '@/verdicts/hearing'
import { loweredWords } from '@/verdicts/levels'
import { playWhole, useFirstListen, withHeard } from '@/verdicts/useFirstListen'
import { useHearing } from '@/verdicts/useHearing'
import { ReasonRow } from '@/verdicts/ReasonRow'
import { useReasons } from '@/verdicts/reasons'
import type { Verdicts } from '@/verdicts/useVerdicts'
import { asked, asks, heardTakes, takeName } from '@/verdicts/words'
import { usePeaks } from '@/verdicts/peaks'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { gain, length } from '@/ui/format'
import { UnreadDot } from '@/ui/UnreadDot'
import { Refusal } from '@/ui/Refusal'

import classes from './Today.module.css'

interface NextUpCardProps {
  item: QueueItem
  projectId: string
  mayApprove: boolean
  player: Player
  playing: PlayerState
  /** The takes that were heard on this page. */
  heardHere: ReadonlySet<string>
  verdicts: Verdicts
}

/** The cue that has waited longest: heard and decided where it stands. */
export function NextUpCard(props: NextUpCardProps) {
  const takes = withHeard(heardTakes(props.item), props.heardHere)
  const [handId, setHandId] = useState(takes[0]?.id)
  const hand = takes.find(({ id }) => id === handId) ?? takes[0]
  return hand && <Heard {...props} takes={takes} hand={hand} onChoose={setHandId} />
}

interface HeardProps extends NextUpCardProps {
  takes: readonly ReviewTake[]
  hand: ReviewTake
  onChoose: (takeId: string) => void
}

function Heard({ item, projectId, mayApprove, player, playing, verdicts, takes, hand, onChoose }: HeardProps) {
  const navigate = useNavigate()
  const narrow = useMediaQuery('(max-width: 760px)')
  const { cue } = item
  const [changing, setChanging] = useState(false)
  const [picking, setPicking] = useState(false)
  const reasons = useReasons(projectId)
  const gains = useMemo(() => matchGains(takes), [takes])
  const source = useHearing(player, cue.id, hand, MASTER, gains)
  const peaks = usePeaks(hand?.peaks_url)
  const sound = soundOf(hand, MASTER)
  const name = takeName(hand, cue, takes)
  const isSet = cue.variations > 1
  const whole = isWholeSet(cue, takes, item.approved_variations)
  const chosen = new Map([[hand.variation, hand.id]])
  const why = whyBlocked(item.blocked)
  const meant = whole ? pickedOfSet(takes, chosen) : [hand]
  const blocked = mayApprove ? blockedWords(meant, why, (take) => takeName(take, cue, takes)) : ''
  const next = takes[(takes.indexOf(hand) + 1) % takes.length]
  const isPlaying = playing.status === 'playing'

  const listen = useFirstListen({
    player,
    playing,
    takes: meant,
    play: (take) => {
      const toPlay = sourceOf(take, MASTER, gains)
      onChoose(take.id)
      if (toPlay) playWhole(player, toPlay)
    },
  })
  const approveNow = (because: readonly string[] = []) => {
    player.pause()
    setPicking(false)
    if (whole) void verdicts.acceptSet(cue, takes, meant, because)
    else void verdicts.approve(cue, [hand], name, because)
  }
  const approve = (because: readonly string[] = []) => listen.approveHeard(meant, () => approveNow(because))
  const openReview = () =>
    void navigate({ to: '/projects/$projectId/review/$cueId', params: { projectId, cueId: cue.id } })
  const playRandomized = () => void player.playRandomized(takes.flatMap((take) => sourceOf(take, MASTER, gains) ?? []))

  useHotkeys([
    { keys: 'Enter', label: 'Open in review', group: 'Today', run: openReview },
    ...takes.slice(0, 9).map((take, index) => ({
      keys: String(index + 1),
      label: `Choose ${takeName(take, cue, takes)}`,
      group: 'Review',
      unlisted: index > 0,
      disabled: picking,
      run: () => onChoose(take.id),
    })),
    {
      keys: 'h',
      label: 'Hold to play the set randomised, as in game',
      group: 'Review',
      run: playRandomized,
      release: () => player.pause(),
      disabled: !isSet,
    },
  ])

  return (
    <Card className={classes.first} aria-labelledby="first">
      <div className="row between top">
        <div>
          <p className="row small mid">
            <UnreadDot />
            First because it has waited longest
          </p>
          <h2 id="first" className={`wrap-anywhere ${classes.asks}`}>
            <Link
              data-stop
              to="/projects/$projectId/review/$cueId"
              params={{ projectId, cueId: cue.id }}
              className={classes.asksLink}
            >
              {asks(item)}
            </Link>
          </h2>
          <p className="mid">{[cue.description || cue.use, `${asked(cue)}.`].filter(Boolean).map(stopped).join(' ')}</p>
        </div>
        <p className="dim small nowrap wide-only mono">{cue.label}</p>
      </div>
      <div className="mt-3">
        <Waveform
          label={`${cue.name}, ${name}`}
          peaks={peaks}
          durationS={sound.durationS}
          clock={player}
          onSeek={(s) => player.seek(s)}
          heightPx={narrow ? 112 : 148}
        />
      </div>
      {takes.length > 1 && (
        <div
          className={`grid gap-2 mt-2 ${classes.alts}`}
          role="radiogroup"
          aria-label={isSet ? 'Variations' : 'Alternates'}
        >
          {takes.map((take) => (
            <TakeCard
              key={take.id}
              flat
              letter={takeName(take, cue, takes).replace('_', '')}
              peaks={take.thumb}
              inHand={take.id === hand.id}
              facts={[
                ...(take.label === null ? [] : [take.label]),
                `${length(soundOf(take, MASTER).durationS)}, ${gain(gains.get(take.id) ?? 0)}`,
              ]}
              onPick={() => onChoose(take.id)}
            />
          ))}
        </div>
      )}
      {(source === null || playing.error) && (
        <p className="small mid">{playing.error ?? 'The preview is not ready yet.'}</p>
      )}
      {blocked && (
        <p className="small">
          {blocked}{' '}
          <Link className="link" to="/projects/$projectId/review/$cueId" params={{ projectId, cueId: cue.id }}>
            Close it in Review
          </Link>
        </p>
      )}
      <div className={`row wrap mt-4 ${classes.acts}`}>
        <HotkeyButton
          keys="Space"
          keyLabel="Play, pause"
          keyGroup="Review"
          icon={isPlaying ? 'pause' : 'play'}
          disabled={source === null}
          onPress={() => void player.toggle()}
        >
          {isPlaying ? 'Pause' : 'Play'}
        </HotkeyButton>
        {takes.length > 1 && next && (
          <HotkeyButton
            keys="b"
            keyLabel="Next alternate at the same position"
            keyGroup="Review"
            icon="ab"
            onPress={() => onChoose(next.id)}
          >
            {isSet ? 'Next variation' : 'Next alternate'}
          </HotkeyButton>
        )}
        {mayApprove ? (
          <>
            <HotkeyButton
              keys="a"
              keyLabel="Approve"
              keyGroup="Review"
              variant="primary"
              icon="tick"
              disabled={blocked !== ''}
              onPress={() => approve()}
            >
              {whole ? `Accept the set of ${cue.variations}` : `Approve ${name}`}
            </HotkeyButton>
            <HotkeyButton
              keys="p"
              keyLabel="Approve with a reason, then 1–9"
              keyGroup="Review"
              pressed={picking}
              disabled={blocked !== ''}
              onPress={() => flushSync(() => setPicking(!picking))}
            >
              Reason
            </HotkeyButton>
            <HotkeyButton
              keys="r"
              keyLabel="Request a change"
              keyGroup="Review"
              icon="pencil"
              iconTone="change"
              onPress={() => {
                player.pause()
                verdicts.change.reset()
                setPicking(false)
                flushSync(() => setChanging(true))
              }}
            >
              Request a change
            </HotkeyButton>
          </>
        ) : (
          <Button icon="comment" keys="Enter" onClick={openReview}>
            Open to comment
          </Button>
        )}
        <span className="small dim wide-only end num">
          {mayApprove ? levelsWords(takes, gains) : 'The approver decides. You can comment.'}
        </span>
      </div>
      {mayApprove && blocked === '' && (
        <p className="small mid">
          <FirstListen
            listen={listen}
            count={meant.length}
            target={MASTER}
            nameOf={(take) => takeName(take, cue, takes)}
            button={whole ? 'Accept the set' : undefined}
            silent={source === null ? 'The preview is not ready yet.' : null}
            onApproveUnheard={() => approveNow()}
          />
        </p>
      )}
      <Refusal {...verdicts.refusal} />
      {picking && mayApprove && blocked === '' && (
        <div className="border-t mt-4 pt-3">
          <ReasonRow
            reasons={reasons.pick}
            title={`Approve ${whole ? `the set of ${cue.variations}` : `${cue.name} ${name}`} because`}
            onReason={(reason) => approve([reason])}
            onClose={() => setPicking(false)}
          />
        </div>
      )}
      {changing && (
        <div className="border-t mt-4 pt-3">
          <ChangeForm
            takeId={hand.id}
            projectId={projectId}
            what={`${cue.name} ${name}`}
            listed={reasons.change}
            positionS={player.positionS()}
            range={null}
            saving={verdicts.change.isPending}
            error={verdicts.change.error}
            onClose={() => setChanging(false)}
            onSave={(change, done) =>
              verdicts.change.mutate(
                { cue, takes: [hand], name, said: change },
                {
                  onSuccess: () => {
                    done()
                    setChanging(false)
                  },
                },
              )
            }
          />
        </div>
      )}
    </Card>
  )
}

const stopped = (text: string): string => (/[.!?]$/.test(text) ? text : `${text}.`)

const levelsWords = (takes: readonly ReviewTake[], gains: Gains): string =>
  takes.length > 1 && takes.every(({ loudness_lufs }) => loudness_lufs !== null)
    ? loweredWords([...gains.values()])
    : ''
