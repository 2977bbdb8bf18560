import { useQueryClient } from '@tanstack/react-query'
import { useRef } from 'react'

import { filesOfField, useLeaveWarning, useUploads } from '@/uploads'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { bytes, bytesOf } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import forms from '../Hiring.module.css'
import { type Entry, useRemoveSound } from './api'
import { useReelPlayer } from '../player'
import { reelUploads } from './reelUploads'

/** The sounds of a reel, played here, and the links to what is elsewhere. */
export function ReelCard({ entry }: { entry: Entry }) {
  const player = useReelPlayer()
  const remove = useRemoveSound(entry.id)
  const queue = reelUploads(useQueryClient(), entry.id)
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  const picker = useRef<HTMLInputElement>(null)
  return (
    <Card aria-labelledby="reel">
      <CardHead id="reel" title="Reel" count={entry.reel.length + entry.links.length} />
      <Rows>
        {entry.reel.map((sound) => {
          const isPlaying = player.playingId === sound.id
          return (
            <Row key={sound.id}>
              <Button
                square
                icon={isPlaying ? 'pause' : 'play'}
                aria-label={`${isPlaying ? 'Pause' : 'Play'} ${sound.title}`}
                onClick={() => player.toggle(sound.id)}
              />
              <span className="grow cut-text">
                {sound.title}
                {player.failedId === sound.id && (
                  <span className="small tone-bad toned"> This browser cannot play it.</span>
                )}
              </span>
              <span className="small dim nowrap">{bytes(sound.file_bytes)}</span>
              <Button
                square
                variant="quiet"
                icon="cross"
                aria-label={`Remove ${sound.title}`}
                onClick={() => remove.mutate(sound.id)}
              />
            </Row>
          )
        })}
        {entry.links.map(({ title, url }) => (
          <Row key={url}>
            <a className="link grow cut-text" href={url} target="_blank" rel="noopener noreferrer">
              {title || new URL(url).host}
            </a>
            <span className="small dim cut-text">{new URL(url).host}</span>
          </Row>
        ))}
        {uploads.map(({ id, file, state, sentBytes, reason }) => (
          <Row key={id}>
            <span className="mono grow cut-text">{file.name}</span>
            <span className={state === 'not_sent' || state === 'already_here' ? 'small tone-bad toned' : 'small dim'}>
              {state === 'already_here' ? 'is on its way already' : (reason ?? bytesOf(sentBytes, file.size))}
            </span>
            <Button
              square
              variant="quiet"
              icon="cross"
              aria-label={`Stop ${file.name}`}
              onClick={() => {
                queue.stop(id)
                queue.dismiss(id)
              }}
            />
          </Row>
        ))}
      </Rows>
      <div className={`grid gap-3 ${forms.body}`}>
        <Refusal error={remove.error} />
        <div className="row wrap">
          <Button icon="upload" onClick={() => picker.current?.click()}>
            Add sounds
          </Button>
          <span className="small dim">WAV, FLAC, MP3, Ogg or M4A, up to 50 MB. Links are added under Profile.</span>
        </div>
      </div>
      <input
        ref={picker}
        type="file"
        hidden
        multiple
        aria-label="Sounds of the reel"
        accept="audio/*"
        onChange={(event) => {
          void queue.add(filesOfField(event.currentTarget.files ?? []), entry.id)
          event.currentTarget.value = ''
        }}
      />
    </Card>
  )
}
