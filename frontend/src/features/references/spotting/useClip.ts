import { type RefObject, useEffect, useState } from 'react'

import { frameRateOf } from './marks'

const FRAMES_READ = 12
const CALM_MS = 100
/** A clip that a browser recorded does not say how long it is, until its end is sought. */
const PAST_ANY_END_S = 1e9

/** Where a clip is, and how it is moved. */
export interface Clip {
  durationS: number
  isPlaying: boolean
  /** Frames a second as the browser shows them, once it has played. */
  measuredRate: number | null
  play: () => void
  seek: (s: number) => void
  /** Where it was when a key or a finger went down, in seconds. */
  positionAt: (eventMs?: number) => number
}

/** Follow a video element. */
export function useClip(video: RefObject<HTMLVideoElement | null>, source: string | undefined): Clip {
  const [durationS, setDuration] = useState(0)
  const [isPlaying, setPlaying] = useState(false)
  const [measuredRate, setRate] = useState<number | null>(null)
  useEffect(() => {
    const element = video.current
    if (element === null) return
    let isSought = false
    const read = () => {
      if (element.duration === Infinity && !isSought) {
        isSought = true
        element.currentTime = PAST_ANY_END_S
      } else if (isSought && Number.isFinite(element.duration)) {
        isSought = false
        element.currentTime = 0
      }
      setDuration(Number.isFinite(element.duration) ? element.duration : 0)
      setPlaying(!element.paused)
    }
    const events = ['loadedmetadata', 'durationchange', 'play', 'pause', 'ended'] as const
    for (const name of events) element.addEventListener(name, read)
    const times: number[] = []
    const frame: VideoFrameRequestCallback = (_, { mediaTime }) => {
      times.push(mediaTime)
      if (times.length < FRAMES_READ) element.requestVideoFrameCallback(frame)
      else setRate(frameRateOf(times))
    }
    if ('requestVideoFrameCallback' in element) element.requestVideoFrameCallback(frame)
    read()
    return () => {
      for (const name of events) element.removeEventListener(name, read)
    }
  }, [video, source])
  return {
    durationS,
    isPlaying,
    measuredRate,
    play: () => {
      const element = video.current
      if (element === null) return
      if (element.paused) void element.play().catch(() => undefined)
      else element.pause()
    },
    seek: (s) => {
      const element = video.current
      if (element) element.currentTime = Math.min(Math.max(0, s), durationS || s)
    },
    positionAt: (eventMs) => {
      const element = video.current
      if (element === null) return 0
      if (element.paused || eventMs === undefined) return element.currentTime
      const agoS = Math.max(0, performance.now() - eventMs) / 1000
      return Math.max(0, element.currentTime - agoS * element.playbackRate)
    },
  }
}

/** The position of a clip while it plays: at every frame, or ten times a second where less motion is wanted. */
export function usePosition(video: RefObject<HTMLVideoElement | null>, source: string | undefined): number {
  const [atS, setAt] = useState(0)
  useEffect(() => {
    const element = video.current
    if (element === null) return
    const isCalm = window.matchMedia('(prefers-reduced-motion: reduce)').matches
    const read = () => setAt(element.currentTime)
    let request = 0
    let lastMs = 0
    const step = (nowMs: number) => {
      if (!isCalm || nowMs - lastMs >= CALM_MS) {
        lastMs = nowMs
        read()
      }
      request = element.paused ? 0 : requestAnimationFrame(step)
    }
    const start = () => {
      cancelAnimationFrame(request)
      request = requestAnimationFrame(step)
    }
    const events = ['seeking', 'seeked', 'pause', 'timeupdate'] as const
    for (const name of events) element.addEventListener(name, read)
    element.addEventListener('play', start)
    return () => {
      cancelAnimationFrame(request)
      for (const name of events) element.removeEventListener(name, read)
      element.removeEventListener('play', start)
    }
  }, [video, source])
  return atS
}
