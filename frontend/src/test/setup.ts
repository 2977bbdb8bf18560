import '@testing-library/jest-dom/vitest'

import { cleanup, configure, prettyDOM } from '@testing-library/react'
import * as React from 'react'
import { afterAll, afterEach, beforeEach, vi } from 'vitest'

import { forgetDrafts } from '@/app/drafts'
import { dismissToast } from '@/app/toast'

// How long an answer takes says how busy the machine is; one that never comes still fails, with what stands there.
configure({
  asyncUtilTimeout: 30_000,
  // Says what is on the page only where somebody reads it: a query that waits fails many times before it succeeds.
  getElementError: (message, container) => {
    const error = new Error()
    error.name = 'TestingLibraryElementError'
    Object.defineProperty(error, 'message', {
      get: () => {
        const page = prettyDOM(container) || ''
        return message?.includes(page) ? message : [message, page].filter(Boolean).join('\n\n')
      },
      set(text: string) {
        Object.defineProperty(error, 'message', { value: text, writable: true })
      },
      configurable: true,
    })
    return error
  },
})

// Each test begins as a page that was just opened, and leaves nothing to the next.
beforeEach(() => {
  document.cookie = 'soundlist_csrf=token-of-the-page'
  sessionStorage.clear()
  localStorage.clear()
  forgetDrafts()
  dismissToast()
})
afterEach(() => {
  cleanup()
  vi.unstubAllGlobals()
})
// Files share modules: one that is still being loaded when a file ends would stay broken for all that follow.
afterAll(() => vi.dynamicImportSettled())

// React notes for its warnings where each element was made, by a stack trace: an eighth of what these tests cost.
const internals = (React as unknown as Record<string, object>)
  .__CLIENT_INTERNALS_DO_NOT_USE_OR_WARN_USERS_THEY_CANNOT_UPGRADE
Object.defineProperty(internals, 'recentlyCreatedOwnerStacks', {
  get: () => Infinity,
  set: () => undefined,
  configurable: true,
})

// jsdom looks for the control of every label each time it is asked for the labels of a control, and every query by
// label or by the name of a button asks for all: an eighth, too.
const LABELABLE = 'button, input:not([type="hidden"]), meter, output, progress, select, textarea'
type Labelable = HTMLButtonElement | HTMLInputElement | HTMLOutputElement | HTMLSelectElement | HTMLTextAreaElement
function labelsOf(this: Labelable): HTMLLabelElement[] | null {
  if (this.type === 'hidden') return null
  return [...this.ownerDocument.getElementsByTagName('label')].filter((label) =>
    label.hasAttribute('for')
      ? this.id !== '' && label.htmlFor === this.id
      : label.contains(this) && label.querySelector(LABELABLE) === this,
  )
}
for (const { prototype } of [
  HTMLButtonElement,
  HTMLInputElement,
  HTMLMeterElement,
  HTMLOutputElement,
  HTMLProgressElement,
  HTMLSelectElement,
  HTMLTextAreaElement,
]) {
  Object.defineProperty(prototype, 'labels', { get: labelsOf, configurable: true })
}

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
// An element's own style, on top of what its tag alone gives: no sheet of ours is here, and jsdom asks every rule of its
// own at each question, a quarter of what these tests cost.
const INLINE = new Set(
  'A ABBR B BUTTON CODE EM I INPUT KBD LABEL MARK OUTPUT S SELECT SMALL SPAN STRONG SUB SUP TEXTAREA TIME'.split(' '),
)
const display = ({ style, hidden, tagName }: HTMLElement) =>
  style.display || (hidden ? 'none' : INLINE.has(tagName) ? 'inline' : 'block')
window.getComputedStyle = ((element: HTMLElement) =>
  new Proxy(element.style, {
    get: (own, name) => {
      if (name === 'display') return display(element)
      if (name === 'getPropertyValue') {
        return (asked: string) => (asked === 'display' ? display(element) : own.getPropertyValue(asked))
      }
      const value: unknown = Reflect.get(own, name, own)
      return typeof value === 'function' ? (value.bind(own) as unknown) : value
    },
  })) as typeof getComputedStyle
// Changing pages scrolls to their top; jsdom has no method for it, and says so each time.
window.scrollTo = () => undefined
