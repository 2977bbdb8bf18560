import '@testing-library/jest-dom/vitest'

import { cleanup, configure } from '@testing-library/react'
import { afterEach, beforeEach, vi } from 'vitest'

import { dismissToast } from '@/app/toast'

// How long an answer takes says how busy the machine is; one that never comes still fails, with what stands there.
configure({ asyncUtilTimeout: 10_000 })

// Each test begins as a page that was just opened, and leaves nothing to the next.
beforeEach(() => {
  document.cookie = 'soundlist_csrf=token-of-the-page'
  sessionStorage.clear()
  dismissToast()
})
afterEach(() => {
  cleanup()
  vi.unstubAllGlobals()
})

// jsdom lays nothing out and paints nothing; these answer as a browser without a screen would.
class StillObserver implements ResizeObserver {
  observe(): void {}
  unobserve(): void {}
  disconnect(): void {}
}
globalThis.ResizeObserver ??= StillObserver
window.matchMedia = (query: string) =>
  ({
    matches: false,
    media: query,
    onchange: null,
    addEventListener: () => undefined,
    removeEventListener: () => undefined,
    addListener: () => undefined,
    removeListener: () => undefined,
    dispatchEvent: () => false,
  }) satisfies MediaQueryList
HTMLCanvasElement.prototype.getContext = () => null
Element.prototype.scrollIntoView = () => undefined
