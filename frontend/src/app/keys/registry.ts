import { keyOf, shiftedDigit } from '@/ui/keyNames'

export interface Hotkey {
  /** `a`, `Space`, `mod+k`, `shift+x`, or a sequence such as `g t`. */
  keys: string
  /** What it does, for the sheet of all keys: "Approve". */
  label: string
  /** Heading on the sheet: "Everywhere", "Review". */
  group?: string
  run: (event: KeyboardEvent) => void
  /** Called when the key is let go; for keys that act while held. */
  release?: () => void
  disabled?: boolean
  /** Repeat while held down; off for verdicts, on for moving. */
  repeats?: boolean
  /** Left off the sheet, as for the ten digits of one list. */
  unlisted?: boolean
}

interface Entry {
  id: number
  scope: number
  read: () => Hotkey
}

const SEQUENCE_MS = 1000
/** What the browser itself presses by Space, and by Enter too; a link knows Enter alone. */
const PRESSED =
  'button,summary,[role=button],[role=option],[role=menuitem],[role=tab],[role=checkbox],[role=radio],[role=switch]'
const PRESSED_BY: Record<string, string> = { Space: PRESSED, Enter: `a[href],${PRESSED}` }

function typesInto(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement)
    return true
  if (!(target instanceof HTMLInputElement)) return target.closest('[role=menu],[role=listbox]') !== null
  return !['checkbox', 'radio', 'button', 'submit', 'range', 'file'].includes(target.type)
}

/** Knows every hotkey in force. The last one registered wins, and only those of the topmost scope hear anything. */
export class KeyRegistry {
  #entries: Entry[] = []
  #scopes: number[] = [0]
  #nextId = 1
  #pressed: string[] = []
  #pressedAt = 0
  #held = new Map<string, () => void>()
  #listeners = new Set<() => void>()
  /** null where keys came or went since it was last asked for. */
  #snapshot: Hotkey[] | null = null
  #on = true

  /** Single keys can be switched off; Escape and those with Ctrl or Cmd stay. */
  get on(): boolean {
    return this.#on
  }

  setOn(on: boolean): void {
    this.#on = on
    this.#changed()
  }

  add(read: () => Hotkey, scope = this.#scopes.at(-1) ?? 0): () => void {
    const entry = { id: this.#nextId++, scope, read }
    this.#entries.push(entry)
    this.#changed()
    return () => {
      this.#entries = this.#entries.filter((other) => other.id !== entry.id)
      this.#changed()
    }
  }

  /** Open a scope, such as a dialog: keys below it are deaf until it closes. */
  openScope(): { scope: number; close: () => void } {
    const scope = this.#nextId++
    this.#scopes.push(scope)
    this.#letGo()
    this.#changed()
    return {
      scope,
      close: () => {
        this.#scopes = this.#scopes.filter((other) => other !== scope)
        this.#changed()
      },
    }
  }

  /** Every hotkey of the page, for the sheet; dialogs' own are left out. */
  listed = (): Hotkey[] =>
    (this.#snapshot ??= this.#entries.filter((entry) => entry.scope === 0).map((entry) => entry.read()))

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  /** Listen on a window until the answer is called. */
  listen(target: Window): () => void {
    const down = (event: KeyboardEvent) => this.#down(event)
    const up = (event: KeyboardEvent) => this.#up(event)
    const blur = () => this.#letGo()
    target.addEventListener('keydown', down)
    target.addEventListener('keyup', up)
    target.addEventListener('blur', blur)
    return () => {
      target.removeEventListener('keydown', down)
      target.removeEventListener('keyup', up)
      target.removeEventListener('blur', blur)
      this.#letGo()
    }
  }

  #changed(): void {
    this.#snapshot = null
    for (const listener of this.#listeners) listener()
  }

  #down(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.isComposing || ['Shift', 'Control', 'Alt', 'Meta'].includes(event.key)) return
    const key = keyOf(event)
    const withModifier = key.startsWith('mod+')
    const alwaysHeard = withModifier || key === 'Escape'
    if (!alwaysHeard && (!this.#on || typesInto(event.target))) return
    if (key === 'Escape' && typesInto(event.target) && this.#scopes.length > 1) return
    const pressed = PRESSED_BY[key]
    if (pressed !== undefined && event.target instanceof Element && event.target.closest(pressed) !== null) return

    const now = event.timeStamp
    this.#pressed = now - this.#pressedAt > SEQUENCE_MS ? [] : this.#pressed
    this.#pressedAt = now
    const sequence = [...this.#pressed, key].join(' ')
    const top = this.#scopes.at(-1) ?? 0
    const heard = this.#entries.filter((entry) => entry.scope === top && !entry.read().disabled)

    const match =
      heard.findLast((entry) => entry.read().keys === sequence) ??
      heard.findLast((entry) => entry.read().keys === key) ??
      // A character that Shift makes of a digit comes first: on some keyboards "/" is one.
      heard.findLast((entry) => entry.read().keys === shiftedDigit(event))
    const begins = heard.some((entry) => entry.read().keys.startsWith(`${sequence} `))
    if (begins && match?.read().keys !== sequence) {
      this.#pressed = sequence.split(' ')
      event.preventDefault()
      return
    }
    this.#pressed = []
    if (match === undefined) {
      if (heard.some((entry) => entry.read().keys.startsWith(`${key} `))) this.#pressed = [key]
      return
    }
    event.preventDefault()
    const hotkey = match.read()
    if (event.repeat && !hotkey.repeats) return
    if (hotkey.release) this.#held.set(key.split('+').at(-1) ?? key, hotkey.release)
    hotkey.run(event)
  }

  #up(event: KeyboardEvent): void {
    const key = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toLowerCase() : event.key
    const release = this.#held.get(key)
    this.#held.delete(key)
    release?.()
  }

  #letGo(): void {
    const held = [...this.#held.values()]
    this.#held.clear()
    for (const release of held) release()
  }
}
