/** Key strings: `a`, `?`, `Space`, `Escape`, `mod+k`, `shift+x`, `ArrowUp`, and sequences with a space: `g t`. */

export const isMac = (): boolean =>
  typeof navigator !== 'undefined' && /Mac|iPhone|iPad/.test(navigator.platform || navigator.userAgent)

const WORDS: Record<string, string> = {
  Escape: 'Esc',
  ArrowUp: '↑',
  ArrowDown: '↓',
  ArrowLeft: '←',
  ArrowRight: '→',
}

/** Name one pressed key the way key strings do. Shift is named only where it does not already change the character. */
export function keyOf(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>): string {
  const key = event.key === ' ' ? 'Space' : event.key.length === 1 ? event.key.toLowerCase() : event.key
  const parts: string[] = []
  if (event.ctrlKey || event.metaKey) parts.push('mod')
  if (event.altKey) parts.push('alt')
  const shiftNamesIt = key.length > 1 || /[a-z]/.test(key)
  if (event.shiftKey && shiftNamesIt) parts.push('shift')
  return [...parts, key].join('+')
}

/** `shift+1` of the key that has a 1, whatever Shift makes of it on this keyboard. */
export function shiftedDigit(event: Pick<KeyboardEvent, 'code' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>) {
  if (!event.shiftKey || event.ctrlKey || event.metaKey || event.altKey) return undefined
  const digit = /^Digit([0-9])$/.exec(event.code)?.[1]
  return digit === undefined ? undefined : `shift+${digit}`
}

/** The caps to draw for a key string, one cap a press: `g t` gives two, `mod+k` one. */
export function capsOf(keys: string, mac = isMac()): string[] {
  return keys.split(' ').map((press) =>
    press
      .split('+')
      .map((part) => {
        if (part === 'mod') return mac ? '⌘' : 'Ctrl'
        if (part === 'alt') return mac ? '⌥' : 'Alt'
        if (part === 'shift') return 'Shift'
        return WORDS[part] ?? (press.includes('+') && part.length === 1 ? part.toUpperCase() : part)
      })
      .join(' '),
  )
}

/** The value of aria-keyshortcuts for a key string, or nothing for a sequence, which ARIA cannot say. */
export function ariaKeys(keys: string): string | undefined {
  if (keys.includes(' ')) return undefined
  return keys
    .replace('mod+', isMac() ? 'Meta+' : 'Control+')
    .replace('shift+', 'Shift+')
    .replace('alt+', 'Alt+')
}
