import { useEffect, useState } from 'react'

/** Plays sounds as they came, one at a time, from where `addressOf` says; what plays ends with the page. */
function useFilePlayer(addressOf: (id: string) => string) {
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
  const play = (id: string, fromS = 0) => {
    audio.src = addressOf(id)
    if (fromS > 0) audio.currentTime = fromS
    setFailed(null)
    setPlaying(id)
    audio.play().catch(() => {
      setPlaying((now) => (now === id ? null : now))
      setFailed(id)
    })
  }
  const toggle = (id: string) => {
    if (playingId !== id) return play(id)
    audio.pause()
    setPlaying(null)
  }
  /** Go on at another sound, at the second where the last one was. */
  const compare = (id: string) => play(id, playingId === null ? 0 : audio.currentTime)
  return { playingId, failedId, toggle, compare }
}

export type FilePlayer = ReturnType<typeof useFilePlayer>

export const useReelPlayer = () => useFilePlayer((id) => `/v1/reel-sounds/${id}/file`)
export const useSamplePlayer = () => useFilePlayer((id) => `/v1/bid-samples/${id}/file`)
