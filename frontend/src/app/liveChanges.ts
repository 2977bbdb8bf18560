import type { Query, QueryClient } from '@tanstack/react-query'

import { checkServer, connection } from '@/api'
import { AFFECTED_BY, FIXED } from '@/api/queryKeys'

/** What the server says of a change: where, and in which of its parts; never what. */
export interface ChangeEvent {
  project_id: string | null
  rooms: readonly string[]
}

type Message = { kind: 'change'; hint: ChangeEvent } | { kind: 'all' } | { kind: 'beat' }

const SILENT_MS = 40_000 // the server sends something every 15 s
const LOOK_MS = 5_000
/** How often pages ask by themselves while nothing comes. */
const POLL_MS = 30_000
const RETRY_MS = [2_000, 5_000, 15_000, 60_000]
/** Between two rounds of asking: the first comes at once, those of a long burst further and further apart. */
const GAP_MS = [1_000, 2_000, 4_000]
const CALM_MS = 5_000

/** Whether what a query asks for may have become another by a change. */
export function isAffected(
  queryKey: readonly unknown[],
  { project_id, rooms }: ChangeEvent,
  projectIds: ReadonlySet<string>,
) {
  const family = String(queryKey[0])
  if (FIXED.has(family)) return false
  const isOfAnother = queryKey.some((part) => typeof part === 'string' && part !== project_id && projectIds.has(part))
  if (project_id !== null && isOfAnother) return false
  return rooms.some((room) => AFFECTED_BY[room]?.has(family) ?? true)
}

/** Asks again for what is on the screen when something changed, at once after a calm and less often in a burst. */
export class Refresher {
  #hints: ChangeEvent[] = []
  #all = false
  #timer: ReturnType<typeof setTimeout> | undefined
  #lastMs = -Infinity
  #round = 0
  readonly #client: QueryClient
  readonly #projectIds: () => ReadonlySet<string>

  constructor(client: QueryClient, projectIds: () => ReadonlySet<string>) {
    this.#client = client
    this.#projectIds = projectIds
  }

  add(hint: ChangeEvent | 'all'): void {
    if (hint === 'all') this.#all = true
    else this.#hints.push(hint)
    if (this.#timer !== undefined) return
    const sinceMs = performance.now() - this.#lastMs
    if (sinceMs > CALM_MS) this.#round = 0
    const gapMs = GAP_MS[Math.min(this.#round, GAP_MS.length - 1)] ?? 0
    this.#timer = setTimeout(() => this.#refresh(), Math.max(0, gapMs - sinceMs))
  }

  stop(): void {
    clearTimeout(this.#timer)
    this.#timer = undefined
  }

  #refresh(): void {
    const [hints, all, projectIds] = [this.#hints, this.#all, this.#projectIds()]
    this.#timer = undefined
    this.#hints = []
    this.#all = false
    this.#lastMs = performance.now()
    this.#round += 1
    const predicate = ({ queryKey }: Query) =>
      all ? !FIXED.has(String(queryKey[0])) : hints.some((hint) => isAffected(queryKey, hint, projectIds))
    // Queries without a mounted page are fetched when one mounts.
    const refetchType = document.visibilityState === 'hidden' ? 'none' : 'active'
    void this.#client.invalidateQueries({ predicate, refetchType }, { cancelRefetch: false })
  }
}

/** Listens to the server until it is stopped; begins again by itself, after a pause that grows. */
function listen(send: (message: Message) => void): () => void {
  let source: EventSource | null = null
  let failures = 0
  let again: ReturnType<typeof setTimeout> | undefined
  let wasOpen = false
  const open = () => {
    const opened = new EventSource('/v1/events')
    source = opened
    opened.addEventListener('open', () => {
      failures = 0
    })
    const on = (name: string, run: (data: unknown) => void) =>
      opened.addEventListener(name, (event) => {
        // A connection that opens is an event named "open" too, without data.
        if (event instanceof MessageEvent) run(JSON.parse(String(event.data)))
      })
    on('open', (data) => {
      if (typeof data !== 'object' || data === null) return
      if (wasOpen && !('resumed' in data && data.resumed === true)) send({ kind: 'all' })
      wasOpen = true
      send({ kind: 'beat' })
    })
    on('change', (hint) => send({ kind: 'change', hint: hint as ChangeEvent }))
    on('beat', () => send({ kind: 'beat' }))
    opened.addEventListener('error', () => {
      void checkServer()
      // The browser connects again by itself after a broken connection, and never after a refusal.
      if (opened.readyState !== EventSource.CLOSED) return
      again = setTimeout(open, RETRY_MS[Math.min(failures++, RETRY_MS.length - 1)])
    })
  }
  open()
  return () => {
    clearTimeout(again)
    source?.close()
  }
}

/** Keep what is on the screen up to date, with one connection for all tabs of the browser; the answer stops it. */
export function followChanges(client: QueryClient, personId: string, projectIds: () => ReadonlySet<string>) {
  if (typeof EventSource === 'undefined') return () => undefined
  const refresher = new Refresher(client, projectIds)
  const others = new BroadcastChannel(`soundlist-changes-${personId}`)
  const ended = new AbortController()
  let heardMs = performance.now()
  let polledMs = heardMs
  let stopListening: () => void = () => undefined

  const hear = (message: Message) => {
    heardMs = performance.now()
    if (message.kind === 'change') refresher.add(message.hint)
    if (message.kind === 'all') refresher.add('all')
  }
  others.onmessage = (event: MessageEvent<Message>) => hear(event.data)
  const hearAndPassOn = (message: Message) => {
    hear(message)
    others.postMessage(message)
  }
  const look = setInterval(() => {
    const now = performance.now()
    if (now - heardMs < SILENT_MS || now - polledMs < POLL_MS) return
    polledMs = now
    refresher.add('all')
  }, LOOK_MS)
  const unsubscribe = connection.subscribe(() => {
    if (!connection.isUnreachable()) refresher.add('all')
  })

  // One tab listens for all: a browser keeps six connections to a server, and each tab would take one.
  const untilEnded = new Promise<void>((resolve) => ended.signal.addEventListener('abort', () => resolve()))
  const listenToServer = () => {
    stopListening = listen(hearAndPassOn)
    return untilEnded
  }
  if ('locks' in navigator) {
    void navigator.locks
      .request(`soundlist-changes-${personId}`, { signal: ended.signal }, listenToServer)
      .catch(() => undefined) // it was ended before its turn came
  } else void listenToServer()

  return () => {
    ended.abort()
    stopListening()
    refresher.stop()
    clearInterval(look)
    unsubscribe()
    others.close()
  }
}
