import { screen } from '@testing-library/react'
import { beforeEach, vi } from 'vitest'

import { dismissToast } from '@/app/toast'

import { HandContext } from './audioContext'
import { openApp } from './openApp'
import { aTakeServer } from './take'

export let server: ReturnType<typeof aTakeServer>
let contexts: HandContext[]

/** Before each test: a server with one version that came back. */
export function serveTakePage() {
  beforeEach(() => {
    dismissToast()
    contexts = []
    vi.stubGlobal(
      'AudioContext',
      class extends HandContext {
        constructor() {
          super()
          contexts.push(this)
        }
      },
    )
    server = aTakeServer()
  })
}

export const opened = async (path = '/takes/t1') => {
  const app = openApp(path)
  await screen.findByRole('heading', { level: 1, name: 'airlock_cycle' })
  return app
}
export const card = (name: string) => screen.findByRole('region', { name })
export const lastContext = () => contexts.at(-1)
export const lastStarted = () => lastContext()?.started.at(-1)
