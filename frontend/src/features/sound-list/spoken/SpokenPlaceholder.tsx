import { useQuery } from '@tanstack/react-query'
import { useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { ago, length } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Refusal } from '@/ui/Refusal'

import { problemIn } from '../api'
import { saidQuery, useRemoveSaid, useSay } from './api'
import { useRecorder } from './useRecorder'

interface SpokenPlaceholderProps {
  cueId: string
  cueName: string
  projectId: string
  /** Whether the person may say one. */
  mayEdit: boolean
}

/** A word that is said for a cue: heard here, and in its placeholder files until the sound comes. */
export function SpokenPlaceholder({ cueId, cueName, projectId, mayEdit }: SpokenPlaceholderProps) {
  const { data: placeholder } = useQuery(saidQuery(cueId))
  const say = useSay(projectId, cueId)
  const remove = useRemoveSaid(projectId, cueId)
  const [unsent, setUnsent] = useState<File | null>(null)
  const audio = useRef<HTMLAudioElement>(null)
  const send = (file: File) => {
    setUnsent(file)
    say.mutate(file, { onSuccess: () => setUnsent(null) })
  }
  const recorder = useRecorder(send)
  useHotkeys([
    {
      keys: 'v',
      label: 'Record a placeholder, while held',
      group: 'Cue',
      run: recorder.start,
      release: recorder.stop,
      disabled: !mayEdit,
    },
  ])
  if (!placeholder && !mayEdit) return null
  const error = say.error ?? remove.error
  return (
    <section className="grid gap-2" aria-label={`Spoken placeholder of ${cueName}`}>
      <p className="small strong">Spoken placeholder</p>
      {placeholder ? (
        <p className="small mid">{`${length(placeholder.duration_s)}, said by ${placeholder.recorded_by.name} ${ago(placeholder.recorded_at)}. The game plays it until a sound is approved.`}</p>
      ) : (
        <p className="small dim">
          Hold v and say what the sound does, as in “bonk”. The game plays it until a sound is approved.
        </p>
      )}
      <div className="row wrap">
        {placeholder && (
          <>
            {/* A word or two, whose text is the name of the cue. */}
            {/* eslint-disable-next-line jsx-a11y/media-has-caption */}
            <audio
              ref={audio}
              src={`/v1/cues/${cueId}/spoken-placeholder/file?v=${placeholder.sha256.slice(0, 12)}`}
              preload="none"
            />
            <Button icon="play" onClick={() => void audio.current?.play().catch(() => undefined)}>
              Play placeholder
            </Button>
          </>
        )}
        {mayEdit && (
          <Button
            keys="v"
            pressed={recorder.isRecording}
            aria-busy={say.isPending}
            onClick={recorder.isRecording ? recorder.stop : recorder.start}
          >
            {recorder.isRecording ? 'Stop' : placeholder ? 'Record again' : 'Record a placeholder'}
          </Button>
        )}
        {mayEdit && placeholder && (
          <Button variant="quiet" aria-busy={remove.isPending} onClick={() => remove.mutate()}>
            Remove
          </Button>
        )}
      </div>
      <p role="status" className="small">
        {recorder.isRecording ? 'Recording, 10 s at most.' : say.isPending ? 'Sending.' : ''}
      </p>
      {recorder.trouble && <ErrorBanner {...recorder.trouble} />}
      <Refusal
        error={error}
        action={
          unsent && problemIn(error)?.status !== 422 ? (
            <Button onClick={() => send(unsent)}>Send it again</Button>
          ) : undefined
        }
      />
    </section>
  )
}
