import { Textarea } from '@mantine/core'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { ApiProblem, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import { formDraft } from '@/app/drafts'
import { DraftForm } from '@/app/drafts/DraftForm'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
// eslint-disable-next-line no-restricted-imports -- the plays of guests are recorded by their link
import { usePlayer, WaveThumb } from '@/audio'
import { Button } from '@/ui/Button'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { length, place as placeWords } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Row, Rows } from '@/ui/Rows'
import { sentence } from '@/ui/sentence'
import { Sheet } from '@/ui/Sheet'
import { PageSkeleton } from '@/ui/Skeleton'

import { doorQuery, type GuestRoom, type GuestSound, openLink, recordPlay, roomQuery, sendGuestComment } from './api'
import { Position } from './Position'
import { keepVisit, keptVisit } from './visits'
import classes from './Shares.module.css'
import { titleOf } from './titles'
import { useEnded } from './useEnded'

/** What people without an account hear by a link. */
export function ListenPage(): ReactNode {
  const { secret } = useParams({ from: '/guest/listen/$secret' })
  const [visit, setVisit] = useState(() => keptVisit(secret))
  useTitle('Listen')
  if (visit === null) {
    return (
      <Door
        secret={secret}
        onOpened={(opened) => {
          keepVisit(secret, opened)
          setVisit(opened)
        }}
      />
    )
  }
  return (
    <Visit
      visit={visit}
      onOver={() => {
        keepVisit(secret, null)
        setVisit(null)
      }}
    />
  )
}

function Gone({ error }: { error: unknown }) {
  const problem = error instanceof ApiProblem ? error : null
  return (
    <Sheet>
      <div className="grid gap-3 p-3-inset-4">
        <h1 className="title">{problem?.detail ?? 'This page could not be loaded.'}</h1>
        {problem?.fix && <p className="mid">{sentence(problem.fix)}</p>}
      </div>
    </Sheet>
  )
}

function Door({ secret, onOpened }: { secret: string; onOpened: (visit: string) => void }) {
  const client = useQueryClient()
  const door = useQuery(doorQuery(secret))
  const open = useMutation({
    mutationFn: (body: Parameters<typeof openLink>[1]) => openLink(secret, body),
    onSuccess: ({ visit, room }) => {
      client.setQueryData(queryKeys.guestRoom(visit), room)
      onOpened(visit)
    },
  })
  if (door.error) return <Gone error={door.error} />
  if (door.data === undefined) return <PageSkeleton />
  const needsPassword = door.data.needs_password
  return (
    <Sheet>
      <div className="grid gap-3 p-3-inset-4">
        <h1 className="title">Listen</h1>
        <p className="mid">The person who sent you this link sees the name that you type, and what you play.</p>
        <Form
          {...formDraft('guest-name', { guest_name: '', password: '' })}
          mutation={open}
          onSubmit={({ guest_name, password }) =>
            open.mutate({ guest_name, password: needsPassword ? password : null })
          }
        >
          <Field name="guest_name" label="Your name" autoComplete="name" />
          {needsPassword && <Field name="password" label="Password of the link" type="password" autoComplete="off" />}
          <Submit>Open</Submit>
        </Form>
      </div>
    </Sheet>
  )
}

function Visit({ visit, onOver }: { visit: string; onOver: () => void }) {
  const { data: room, error } = useQuery(roomQuery(visit))
  useTitle(room?.title ?? 'Listen')
  if (error) {
    return (
      <>
        <Gone error={error} />
        <p className={classes.again}>
          <button type="button" className="link" onClick={onOver}>
            Open the link again
          </button>
        </p>
      </>
    )
  }
  if (!room) return <PageSkeleton />
  return <Room visit={visit} room={room} />
}

const GROUP = 'Listen'

function Room({ visit, room }: { visit: string; room: GuestRoom }) {
  const { sounds, title } = room
  const [player, playing] = usePlayer()
  const [at, setAt] = useState(0)
  const [problem, setProblem] = useState<ApiProblem | null>(null)
  const current = sounds[at]
  const isPlaying = playing.status === 'playing'
  const play = async (to: number) => {
    const sound = sounds[to]
    if (!sound) return
    setAt(to)
    setProblem(null)
    try {
      player.pause()
      await recordPlay(visit, sound.place) // what a guest plays is on record before it is sent
      await player.select({
        id: String(sound.place),
        url: `/v1/guest-visits/${encodeURIComponent(visit)}/sounds/${sound.place}/preview`,
      })
      await player.play(0)
    } catch (error) {
      if (error instanceof ApiProblem) setProblem(error)
    }
  }
  // One tap plays through: at the end of a sound the next one follows that is ready.
  useEnded(player, () => {
    const next = sounds.findIndex((sound, index) => index > at && sound.is_ready)
    if (next > at) void play(next)
  })
  const toggle = () => {
    const isHeld = playing.sourceId === String(current?.place)
    if (isPlaying) player.pause()
    else if (isHeld && player.positionS() > 0 && player.positionS() < playing.durationS) void player.play()
    else void play(at)
  }
  useHotkeys([
    { keys: 'Space', label: 'Play or pause', group: GROUP, run: toggle },
    { keys: 'j', label: 'Next sound', group: GROUP, run: () => void play(at + 1), repeats: true },
    { keys: 'k', label: 'Previous sound', group: GROUP, run: () => void play(at - 1), repeats: true },
  ])
  return (
    <div className={`page stack content-start ${classes.page} ${classes.narrow}`}>
      <header className="row wrap">
        <h1>{title}</h1>
        <span className="small dim">for {room.guest_name}</span>
      </header>
      <Refusal error={problem} />
      {playing.error && <ErrorBanner detail={playing.error} />}
      {current && (
        <section aria-label="Now" className={classes.now}>
          <p className="title cut-text">{titleOf(current)}</p>
          <Position
            player={player}
            durationS={current.duration_s ?? 0}
            thumb={current.thumb}
            onSeek={(s) => player.seek(s)}
            disabled={playing.sourceId !== String(current.place)}
          />
          <div className="row wrap">
            <Button
              square
              tall
              icon="back"
              aria-label="Previous sound"
              disabled={at === 0}
              onClick={() => void play(at - 1)}
            />
            <Button
              variant="primary"
              tall
              icon={isPlaying ? 'pause' : 'play'}
              keys="Space"
              aria-busy={playing.status === 'loading'}
              disabled={!current.is_ready}
              onClick={toggle}
            >
              {isPlaying ? 'Pause' : 'Play'}
            </Button>
            <Button
              square
              tall
              icon="right"
              aria-label="Next sound"
              disabled={at >= sounds.length - 1}
              onClick={() => void play(at + 1)}
            />
            {!current.is_ready && <span className="small mid">It is being made ready.</span>}
          </div>
          {room.may_comment && (
            <Comment key={current.place} visit={visit} sound={current} positionS={() => player.positionS()} />
          )}
        </section>
      )}
      <section aria-label="Sounds" className={classes.list}>
        <Rows aria-label="Sounds">
          {sounds.map((sound, index) => (
            <Row key={sound.place} selected={index === at}>
              <button
                type="button"
                className={`flex items-center flex-1 min-w-0 min-h-28px p-0 font-inherit bg-none border-0 pointer narrow-min-h-44px ${classes.sound}`}
                onClick={() => void play(index)}
              >
                <span className="strong cut-text">{titleOf(sound)}</span>
              </button>
              <span className={`wide-only ${classes.thumb}`}>
                <WaveThumb peaks={sound.thumb} highlighted={index === at} />
              </span>
              <span className="small mid num nowrap">{sound.duration_s === null ? '' : length(sound.duration_s)}</span>
            </Row>
          ))}
        </Rows>
      </section>
    </div>
  )
}

function Comment({ visit, sound, positionS }: { visit: string; sound: GuestSound; positionS: () => number }) {
  const [sent, setSent] = useState<{ text: string; startS: number | null }[]>([])
  const send = useMutation({
    mutationFn: ({ text, startS }: { text: string; startS: number | null }) =>
      sendGuestComment(visit, sound.place, text, startS),
    onSuccess: (_, comment) => setSent((before) => [...before, comment]),
  })
  const startOf = (atS: number) =>
    atS > 0 && sound.duration_s !== null && atS < sound.duration_s ? Math.floor(atS * 1000) / 1000 : null
  return (
    <>
      <ul aria-label="What you wrote" aria-live="polite">
        {sent.map((comment) => (
          <li key={`${comment.startS} ${comment.text}`} className="small">
            {comment.startS !== null && <span className="mono dim">{placeWords(comment.startS)} </span>}
            {comment.text} <span className="dim">sent</span>
          </li>
        ))}
      </ul>
      <DraftForm
        className="grid grid-cols-1 gap-3"
        draftKey={`guest-comment:${visit.slice(0, 8)}:${sound.place}`}
        initialValues={{ text: '' }}
        mutation={send}
        onSubmit={({ text }, onSuccess) => {
          const trimmed = text.trim()
          if (trimmed !== '') send.mutate({ text: trimmed, startS: startOf(positionS()) }, { onSuccess })
        }}
      >
        <Field
          as={Textarea}
          optional
          name="text"
          rows={2}
          maxLength={10_000}
          aria-label={`Comment on ${titleOf(sound)}`}
          placeholder="Comment, at the place where the playhead stands"
        />
        <Submit variant="plain" icon="comment">
          Send comment
        </Submit>
      </DraftForm>
    </>
  )
}
