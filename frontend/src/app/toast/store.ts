export interface Toast {
  id: number
  text: string
  /** Takes it back; the toast then leaves. */
  undo?: () => void | Promise<void>
}

export const TOAST_MS = 10_000

let current: Toast | null = null
let nextId = 1
const listeners = new Set<() => void>()

function set(toast: Toast | null): void {
  current = toast
  for (const listener of listeners) listener()
}

/** Say what was done, with Undo where it can be taken back. One at a time; never for errors, which stay where they happened. */
export function showToast(text: string, undo?: Toast['undo']): void {
  set({ id: nextId++, text, undo })
}

export function dismissToast(id?: number): void {
  if (id === undefined || current?.id === id) set(null)
}

export const toastStore = {
  get: (): Toast | null => current,
  subscribe: (listener: () => void): (() => void) => {
    listeners.add(listener)
    return () => listeners.delete(listener)
  },
}
