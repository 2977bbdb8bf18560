import {
  createContext,
  type ReactNode,
  useContext,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
  useSyncExternalStore,
} from 'react'

import type { IconName } from '@/ui/Icon'

/** Something to do, offered under "Do". */
export interface Command {
  id: string
  label: string
  icon?: IconName
  /** The key that does the same outside the palette. */
  keys?: string
  /** Other words it is found by. */
  also?: string[]
  run: () => void
}

/** Something found, such as a sound or a comment. */
export interface Found {
  id: string
  title: string
  /** Before the title, in mono: a cue number. */
  number?: string
  /** After the title: a state, an age. */
  detail?: ReactNode
  open: () => void
}

/** Asked at every change of the query; the signal aborts a search that is no longer needed. */
export interface SearchProvider {
  id: string
  /** Heading of its results: "Sounds", "Said". */
  title: string
  search: (query: string, signal: AbortSignal) => Promise<Found[]>
  /** Shown after the commands rather than before them. */
  last?: boolean
}

class Registered<T extends { id: string }> {
  #items: { read: () => T }[] = []
  #listeners = new Set<() => void>()
  #snapshot: T[] = []

  add(read: () => T): () => void {
    const entry = { read }
    this.#items.push(entry)
    this.#changed()
    return () => {
      this.#items = this.#items.filter((other) => other !== entry)
      this.#changed()
    }
  }

  all = (): T[] => this.#snapshot

  subscribe = (listener: () => void): (() => void) => {
    this.#listeners.add(listener)
    return () => this.#listeners.delete(listener)
  }

  #changed(): void {
    this.#snapshot = this.#items.map(({ read }) => read())
    for (const listener of this.#listeners) listener()
  }
}

interface Palette {
  commands: Registered<Command>
  providers: Registered<SearchProvider>
}

const Context = createContext<Palette | null>(null)

export function PaletteProvider({ children }: { children: ReactNode }) {
  const [palette] = useState<Palette>(() => ({ commands: new Registered(), providers: new Registered() }))
  return <Context value={palette}>{children}</Context>
}

function usePalette(): Palette {
  const palette = useContext(Context)
  if (palette === null) throw new Error('PaletteProvider is missing')
  return palette
}

function useRegistered<T extends { id: string }>(registered: Registered<T>, items: T[], shape: string): void {
  const latest = useRef(items)
  useLayoutEffect(() => {
    latest.current = items
  })
  useEffect(() => {
    const removers = latest.current.map((item, index) => registered.add(() => latest.current[index] ?? item))
    return () => {
      for (const remove of removers) remove()
    }
  }, [registered, shape])
}

/** Offer commands in the palette while the component is mounted. */
export function useCommands(commands: Command[]): void {
  useRegistered(usePalette().commands, commands, commands.map(({ id, label }) => `${id}\n${label}`).join('\n\n'))
}

/** Let the palette search something while the component is mounted. */
export function useSearchProvider(provider: SearchProvider): void {
  useRegistered(usePalette().providers, [provider], `${provider.id}\n${provider.title}`)
}

export function useRegisteredCommands(): Command[] {
  const { commands } = usePalette()
  return useSyncExternalStore(commands.subscribe, commands.all)
}

export function useRegisteredProviders(): SearchProvider[] {
  const { providers } = usePalette()
  return useSyncExternalStore(providers.subscribe, providers.all)
}
