import { useEffect, useRef, useState } from 'react'

import { wavOf } from './wav'

const LONGEST_MS = 10_000
/** The word is recorded, not cleaned: the server trims and levels it. */
const PLAIN = { channelCount: 1, echoCancellation: false, noiseSuppression: false, autoGainControl: true }

interface Recorder {
  isRecording: boolean
  /** Why nothing is recorded, and what to do about it. */
  trouble: { detail: string; fix: string } | null
  start: () => void
  stop: () => void
}

/** Record one word from the microphone as a WAV file. */
export function useRecorder(onRecorded: (file: File) => void): Recorder {
  const [isRecording, setRecording] = useState(false)
  const [trouble, setTrouble] = useState<Recorder['trouble']>(null)
  const recorder = useRef<MediaRecorder | null>(null)
  const isWanted = useRef(false)
  const timer = useRef<ReturnType<typeof setTimeout>>(undefined)
  const latest = useRef(onRecorded)
  useEffect(() => {
    latest.current = onRecorded
  })
  const stop = () => {
    isWanted.current = false
    clearTimeout(timer.current)
    if (recorder.current?.state === 'recording') recorder.current.stop()
  }
  useEffect(() => stop, [])
  const record = (stream: MediaStream) => {
    const parts: Blob[] = []
    const mediaRecorder = new MediaRecorder(stream)
    recorder.current = mediaRecorder
    mediaRecorder.addEventListener('dataavailable', ({ data }) => parts.push(data))
    mediaRecorder.addEventListener('stop', () => {
      for (const track of stream.getTracks()) track.stop()
      setRecording(false)
      wavOf(new Blob(parts, { type: mediaRecorder.mimeType })).then(
        (file) => latest.current(file),
        () => setTrouble({ detail: 'The recording was too short to be read.', fix: 'Hold the key while you speak.' }),
      )
    })
    mediaRecorder.start()
    setRecording(true)
    timer.current = setTimeout(stop, LONGEST_MS)
  }
  const start = () => {
    if (isWanted.current) return
    isWanted.current = true
    setTrouble(null)
    microphone().then(
      (stream) => {
        if (isWanted.current) record(stream)
        else {
          for (const track of stream.getTracks()) track.stop()
          setTrouble({ detail: 'The microphone is ready.', fix: 'Hold the key again while you speak.' })
        }
      },
      (error: unknown) => {
        isWanted.current = false
        setTrouble(troubleOf(error))
      },
    )
  }
  return { isRecording, trouble, start, stop }
}

async function microphone(): Promise<MediaStream> {
  // Browsers hide it on pages without https.
  const devices = navigator.mediaDevices as MediaDevices | undefined
  if (devices === undefined) throw new DOMException('no devices', 'SecurityError')
  return devices.getUserMedia({ audio: PLAIN })
}

function troubleOf(error: unknown): NonNullable<Recorder['trouble']> {
  const name = error instanceof DOMException ? error.name : ''
  if (name === 'NotAllowedError') {
    return {
      detail: 'The browser does not allow this page to use the microphone.',
      fix: 'Allow the microphone beside the address of the page, then try again.',
    }
  }
  if (name === 'NotFoundError') return { detail: 'No microphone was found.', fix: 'Connect one, then try again.' }
  if (name === 'SecurityError') {
    return { detail: 'Browsers record only on pages with https.', fix: 'Open Soundlist by its https address.' }
  }
  return { detail: 'The microphone could not be opened.', fix: 'Close other programs that use it, then try again.' }
}
