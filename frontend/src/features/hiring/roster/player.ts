import { useEffect, useState } from 'react'

import type { ReelSound } from './api'

/** Plays sounds of reels, one at a time; what plays ends with the page. */
export function useReelPlayer() {
  const [audio] = useState(() => new Audio())
  const [playingId, setPlaying] = useState<string | null>(null)
  const [failedId, setFailed] = useState<string | null>(null)
  useEffect(() => {
    const ended = () => setPlaying(null)
    audio.addEventListener('ended', ended)
    return () => {
      audio.removeEventListener('ended', ended)
      audio.pause()
      audio.removeAttribute('src')
    }
  }, [audio])
  const toggle = ({ id }: ReelSound) => {
    if (playingId === id) {
      audio.pause()
      setPlaying(null)
      return
    }
    audio.src = `/v1/reel-sounds/${id}/file`
    setFailed(null)
    setPlaying(id)
    audio.play().catch(() => {
      setPlaying((now) => (now === id ? null : now))
      setFailed(id)
    })
  }
  return { playingId, failedId, toggle }
}
