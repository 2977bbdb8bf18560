import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { type ReactNode, useEffect, useEffectEvent, useRef, useState } from 'react'

import { meQuery } from '@/api/me'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { WaveThumb } from '@/audio'
import { NotHeard } from '@/heard/NotHeard'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { Button } from '@/ui/Button'
import { Count } from '@/ui/Count'
import { Refusal } from '@/ui/Refusal'
import { length, plural } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Row, Rows } from '@/ui/Rows'
import { PageSkeleton } from '@/ui/Skeleton'

import { type Playlist, playlistQuery, savePosition, useChangePlaylist, useRemovePlaylist } from './api'
import { LivePanel } from './LivePanel'
import { moved } from './order'
import { Position } from './Position'
import { titleOf } from './titles'
import classes from './Shares.module.css'
import { useLive } from './useLive'
import { usePlaythrough } from './usePlaythrough'
import { VerdictOfTake } from './VerdictOfTake'

const GROUP = 'Playlist'

/** A playlist: put in order, played through, judged on the way, alone or together. */
export function PlaylistPage(): ReactNode {
  const { playlistId = '' } = useParams({ strict: false })
  const { data: playlist, error } = useQuery(playlistQuery(playlistId))
  useTitle(playlist?.name ?? 'Playlist')
  if (error) {
    return (
      <div className="page">
        <h1>Playlist</h1>
        <Refusal error={error} />
      </div>
    )
  }
  if (!playlist) return <PageSkeleton />
  return <Room key={playlistId} playlist={playlist} />
}

function Room({ playlist }: { playlist: Playlist }) {
  const { id, project_id: projectId, takes, position, may_share: mayChange, may_join: mayJoin } = playlist
  const navigate = useNavigate()
  const { data: me } = useQuery(meQuery)
  const [player, playing, heardHere] = useTakePlayer(projectId)
  const change = useChangePlaylist(id)
  const remove = useRemovePlaylist(projectId, id)
  const [dragged, setDragged] = useState<string | null>(null)
  const start = { takeId: position?.take_id, atS: position?.at_s ?? 0 }
  /** The one that is heard before it is approved: the next one waits until then. */
  const staysOn = useRef<string | null>(null)
  const playButton = useRef<HTMLButtonElement>(null)
  const playthrough = usePlaythrough(
    player,
    takes,
    start,
    ({ take_id: takeId }) => hand.lead(takeId, player.isPlaying(), player.positionS()),
    () => staysOn.current === currentId,
  )
  const { current, step } = playthrough
  const hand = useLive(id, mayJoin, player, playthrough)
  const currentId = current?.take_id
  const follows = hand.isIn && hand.live?.is_holder === false
  const isPlaying = playing.status === 'playing'
  const order = takes.map(({ take_id }) => take_id)

  const open = async (takeId: string, how?: { plays: boolean }) => {
    if (follows) return
    staysOn.current = null
    await playthrough.open(takeId, how)
    hand.lead(takeId, player.isPlaying(), player.positionS())
  }
  const toggle = async () => {
    if (follows || !current) return
    await player.toggle()
    hand.lead(current.take_id, player.isPlaying(), player.positionS())
  }
  const seek = (s: number) => {
    if (follows || !current) return
    player.seek(s)
    hand.lead(current.take_id, player.isPlaying(), s)
  }
  const goBy = (by: 1 | -1, how?: { plays: boolean }) => {
    const take = step(by)
    if (take) void open(take.take_id, how)
  }
  const unheard = takes.filter(({ is_heard: isHeard }) => isHeard === false)
  const toUnheard = () => {
    const at = takes.findIndex(({ take_id }) => take_id === currentId)
    const ahead = [...takes.slice(at + 1), ...takes.slice(0, Math.max(0, at))]
    const next = ahead.find((take) => unheard.includes(take) && take.preview_url !== null)
    if (next) void open(next.take_id)
    else showToast('You have heard every other sound of this playlist.')
  }
  const move = (takeId: string, to: number) => {
    const next = moved(order, takeId, to)
    if (next.join() !== order.join()) change.mutate({ take_ids: next })
  }
  const moveFocused = (by: 1 | -1) => {
    const row = document.activeElement?.closest<HTMLElement>('[data-take]')?.dataset.take
    if (row !== undefined && mayChange) move(row, order.indexOf(row) + by)
  }
  useHotkeys([
    { keys: 'Space', label: 'Play or pause', group: GROUP, run: () => void toggle() },
    { keys: 'j', label: 'Next sound', group: GROUP, run: () => goBy(1), repeats: true },
    { keys: 'k', label: 'Previous sound', group: GROUP, run: () => goBy(-1), repeats: true },
    {
      keys: 'shift+j',
      label: 'Next that you have not heard',
      group: GROUP,
      run: toUnheard,
      disabled: !mayJoin || follows,
    },
    { keys: 'alt+ArrowUp', label: 'Move the sound up', group: GROUP, run: () => moveFocused(-1), disabled: !mayChange },
    {
      keys: 'alt+ArrowDown',
      label: 'Move the sound down',
      group: GROUP,
      run: () => moveFocused(1),
      disabled: !mayChange,
    },
  ])

  // Where one stopped is kept when the sound is paused or changed, and when the page is left.
  const keep = useEffectEvent(() => {
    if (current) void savePosition(id, current.take_id, player.positionS()).catch(() => undefined)
  })
  useEffect(() => {
    if (playing.status === 'paused') keep()
  }, [playing.status, currentId])
  useEffect(() => () => keep(), [])

  return (
    <div className={`page stack content-start ${classes.page}`}>
      <header className="row wrap">
        <h1>{playlist.name}</h1>
        <Count of={takes.length} />
        <span className="small dim">by {playlist.made_by.name}</span>
        {unheard.length > 0 && <span className="small mid num">{unheard.length} not heard yet</span>}
        <span className="end row wrap">
          {mayChange && (
            <Link className="link" to="/projects/$projectId/sharing" params={{ projectId }} search={{ playlist: id }}>
              Share with guests
            </Link>
          )}
          {mayChange && (
            <Button
              icon="cross"
              onClick={() =>
                remove.mutate(undefined, {
                  onSuccess: () => {
                    showToast('Playlist removed. Guest links made of it stay.')
                    void navigate({ to: '/projects/$projectId/sharing', params: { projectId }, search: {} })
                  },
                })
              }
            >
              Remove
            </Button>
          )}
        </span>
      </header>
      <Refusal error={change.error} />
      {current && (
        <section aria-label="Now" className={classes.now}>
          <p className="row wrap min-w-0">
            <span className="title cut-text">{titleOf(current)}</span>{' '}
            <span className="small dim mono">{current.cue_label}</span>{' '}
            {current.label !== null && <span className="small">{current.label}</span>}
          </p>
          <Position
            player={player}
            durationS={current.duration_s ?? playing.durationS}
            thumb={current.thumb}
            onSeek={seek}
            disabled={follows}
          />
          {playing.error && <ErrorBanner detail={playing.error} />}
          <div className="row wrap">
            <Button
              square
              icon="back"
              aria-label="Previous sound"
              disabled={follows || !step(-1)}
              onClick={() => goBy(-1)}
              tall
            />
            <Button
              ref={playButton}
              variant="primary"
              tall
              icon={isPlaying ? 'pause' : 'play'}
              keys="Space"
              disabled={follows}
              onClick={() => void toggle()}
            >
              {isPlaying ? 'Pause' : 'Play'}
            </Button>
            <Button
              square
              icon="right"
              aria-label="Next sound"
              disabled={follows || !step(1)}
              onClick={() => goBy(1)}
              tall
            />
            {follows && (
              <span className="small mid">
                {hand.live?.is_elsewhere
                  ? 'Your other tab plays.'
                  : `${hand.live?.holder?.name ?? 'The session'} plays for all.`}
              </span>
            )}
          </div>
          <VerdictOfTake
            key={current.take_id}
            projectId={projectId}
            playlistId={id}
            take={current}
            player={player}
            playing={playing}
            heardHere={heardHere}
            onPlayFromStart={follows ? null : () => void open(current.take_id, { plays: true })}
            onListen={() => (staysOn.current = current.take_id)}
            mayReview={mayJoin}
            onJudged={() => goBy(1, staysOn.current === null ? undefined : { plays: true })}
          />
        </section>
      )}
      <div className={`grid items-start gap-4 ${classes.two}`}>
        <section aria-label="Sounds" className={classes.list}>
          <Rows aria-label={`${plural(takes.length, 'sound')} in order`}>
            {takes.map((take, at) => (
              <Row
                key={take.take_id}
                data-take={take.take_id}
                selected={take.take_id === currentId}
                draggable={mayChange}
                data-dragged={dragged === take.take_id || undefined}
                onDragStart={() => setDragged(take.take_id)}
                onDragEnd={() => setDragged(null)}
                onDragOver={(event) => {
                  if (dragged !== null) event.preventDefault()
                }}
                onDrop={() => {
                  if (dragged !== null) move(dragged, at)
                }}
              >
                <span className={`small dim num flex-none ${classes.place}`}>{at + 1}</span>
                <button
                  type="button"
                  className={`flex items-center flex-1 min-w-0 min-h-28px p-0 font-inherit bg-none border-0 pointer narrow-min-h-44px ${classes.sound} ${classes.entry}`}
                  onClick={() => void open(take.take_id)}
                  disabled={follows}
                >
                  <span className="strong cut-text">{titleOf(take)}</span>{' '}
                  <span className="small dim nowrap">version {take.number}</span>{' '}
                  {take.label !== null && <span className="small cut-text">{take.label}</span>}
                  {take.is_heard === false && <NotHeard />}
                </button>
                <span className={`wide-only ${classes.thumb}`}>
                  <WaveThumb peaks={take.thumb} highlighted={take.take_id === currentId} />
                </span>
                <span className="small mid num nowrap">{take.duration_s === null ? '' : length(take.duration_s)}</span>
                {mayChange && (
                  <span className="flex">
                    <Button
                      variant="quiet"
                      square
                      icon="chevron"
                      className={classes.up}
                      aria-label={`Move ${titleOf(take)} up`}
                      disabled={at === 0}
                      onClick={() => move(take.take_id, at - 1)}
                    />
                    <Button
                      variant="quiet"
                      square
                      icon="chevron"
                      aria-label={`Move ${titleOf(take)} down`}
                      disabled={at === takes.length - 1}
                      onClick={() => move(take.take_id, at + 1)}
                    />
                    <Button
                      variant="quiet"
                      square
                      icon="cross"
                      aria-label={`Take ${titleOf(take)} out`}
                      disabled={takes.length === 1}
                      onClick={() => change.mutate({ take_ids: order.filter((takeId) => takeId !== take.take_id) })}
                    />
                  </span>
                )}
              </Row>
            ))}
          </Rows>
        </section>
        {mayJoin && <LivePanel hand={hand} meId={me?.person.id} onJoin={() => playButton.current?.focus()} />}
      </div>
    </div>
  )
}
