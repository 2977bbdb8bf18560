import type { InfiniteData, QueryClient } from '@tanstack/react-query'

import { ApiProblem, post } from '@/api'
import { serverReturns } from '@/api/connection'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import type { CueReview, QueuePage, ReviewTake } from '@/verdicts/api'

type Playlist = components['schemas']['PlaylistRead']
type CueProgress = components['schemas']['CueProgress']

const PREFIX = 'soundlist-heard'
/** What is heard within this time is sent together. */
const GATHER_MS = 2_000
/** As many as the server takes at once. */
const AT_ONCE = 200

/** What one person heard in one project, kept in this browser until the server has it. */
export class HeardTakes {
  #unsent: string[] = []
  #sending = false
  #timer: ReturnType<typeof setTimeout> | undefined
  readonly #key: string
  readonly #projectId: string
  readonly #onSent: (takeIds: readonly string[]) => void

  constructor(personId: string, projectId: string, onSent: (takeIds: readonly string[]) => void) {
    this.#key = `${PREFIX}:${personId}:${projectId}`
    this.#projectId = projectId
    this.#onSent = onSent
    if (this.#read().length > 0) void this.send()
  }

  add(takeId: string): void {
    this.#keep([...new Set([...this.#read(), takeId])])
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => void this.send(), GATHER_MS)
  }

  /** Send what is kept; while the line is lost, wait for it. What the server refuses is dropped. */
  async send(): Promise<void> {
    clearTimeout(this.#timer)
    if (this.#sending) return
    this.#sending = true
    try {
      for (let some = this.#read().slice(0, AT_ONCE); some.length > 0; some = this.#read().slice(0, AT_ONCE)) {
        const status = await this.#statusOf(some)
        if (status === 0) await serverReturns()
        else if (status >= 500 || status === 401 || status === 429)
          return // sent with what is heard next
        else {
          this.#keep(this.#read().filter((takeId) => !some.includes(takeId)))
          if (status < 400) this.#onSent(some)
        }
      }
    } finally {
      this.#sending = false
    }
  }

  async #statusOf(takeIds: string[]): Promise<number> {
    try {
      await post('/v1/projects/{project_id}/heard-takes', { project_id: this.#projectId }, { take_ids: takeIds })
      return 204
    } catch (error) {
      return error instanceof ApiProblem ? error.status : 0
    }
  }

  #keep(takeIds: string[]): void {
    this.#unsent = takeIds
    try {
      if (takeIds.length === 0) localStorage.removeItem(this.#key)
      else localStorage.setItem(this.#key, JSON.stringify(takeIds))
    } catch {
      // A browser that keeps nothing keeps them as long as the page stands.
    }
  }

  /** What is not sent, that of the person's other tabs included. */
  #read(): string[] {
    try {
      const kept: unknown = JSON.parse(localStorage.getItem(this.#key) ?? '[]')
      const ids = Array.isArray(kept) ? kept.filter((id): id is string => typeof id === 'string') : []
      return ids.length > 0 ? ids : this.#unsent
    } catch {
      return this.#unsent
    }
  }
}

/** Show takes as heard wherever they are on the screen, before the server says so. */
export function markHeard(client: QueryClient, projectId: string, takeIds: readonly string[]): void {
  const heard = (take: ReviewTake) => (takeIds.includes(take.id) ? { ...take, is_heard: true } : take)
  client.setQueriesData<InfiniteData<QueuePage> | object>({ queryKey: queryKeys.reviewQueue(projectId) }, (queue) =>
    queue && 'pages' in queue
      ? {
          ...queue,
          pages: queue.pages.map((page) => ({
            ...page,
            items: page.items.map((item) => ({ ...item, takes: item.takes.map(heard) })),
          })),
        }
      : queue,
  )
  client.setQueriesData<CueReview>(
    { queryKey: queryKeys.cueReview.all },
    (review) => review && { ...review, takes: review.takes.map(heard) },
  )
  client.setQueriesData<Playlist | object>({ queryKey: queryKeys.playlist.all }, (playlist) =>
    playlist && 'takes' in playlist
      ? {
          ...playlist,
          takes: playlist.takes.map((take) => (takeIds.includes(take.take_id) ? { ...take, is_heard: true } : take)),
        }
      : playlist,
  )
  client.setQueryData<CueProgress[]>(queryKeys.progress(projectId, 'cues'), (cues) =>
    cues?.map((cue) => {
      const left = cue.unheard_take_ids.filter((id) => !takeIds.includes(id))
      return left.length < cue.unheard_take_ids.length ? { ...cue, unheard_take_ids: left } : cue
    }),
  )
}
