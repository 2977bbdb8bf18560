import { vi } from 'vitest'

import { Player } from '@/audio/player'

import { HandContext } from './audioContext'

interface HandParts {
  random?: () => number
  reducedMotion?: boolean
  held?: boolean
}

/** A player whose clocks and frames are turned by hand, and a network that answers with `sounds`. */
export class Hand {
  readonly context = new HandContext()
  fetched: string[] = []
  frames: (() => void)[] = []
  clockMs = 0

  constructor(sounds: Record<string, { durationS: number; samples?: number[] }>) {
    vi.stubGlobal('fetch', (url: string) => {
      this.fetched.push(url)
      const sound = sounds[url]
      return Promise.resolve(new Response(sound ? JSON.stringify(sound) : null, { status: sound ? 200 : 404 }))
    })
  }

  player({ random = () => 0, reducedMotion = false, held }: HandParts = {}): Player {
    return new Player({
      createContext: () => this.context as unknown as AudioContext,
      random,
      reducedMotion: () => reducedMotion,
      now: () => this.clockMs,
      held,
      onFrame: (callback) => {
        this.frames.push(callback)
        return () => {
          this.frames = this.frames.filter((other) => other !== callback)
        }
      },
    })
  }
}
