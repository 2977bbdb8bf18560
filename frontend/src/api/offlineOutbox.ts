import { csrfToken, newIdempotencyKey, send } from './client'
import { serverReturns } from './connection'
import { outbox, REFUSED, type RefusedWrite, WAITING, type WriteKind } from './outbox'
import { ApiProblem, problemOf } from './problem'

/** A write of one person, kept in this browser until the server has answered it. */
interface KeptWrite {
  /** Its place in the order, and the name it is kept under. */
  place: string
  /** Sent with it each time, so that it counts once. */
  key: string
  method: string
  path: string
  body: string
  /** What it does, in words: "Approve shield_hit A". */
  what: string
  /** The key of the write that it undoes: it is sent behind that one, and only if that one is accepted. */
  undoes?: string
}

/** Who asked for a write on this page. */
interface Asked {
  answer: (response: Response) => void
  drop: () => void
  onKept: () => void
  /** It was said to wait for the connection, and the person went on. */
  isKept: boolean
}

const BUSY_MS = 2_000

function kindOf({ method, path }: KeptWrite): WriteKind {
  if (method === 'DELETE') return 'undo'
  return path.endsWith('/comments') ? 'comment' : 'verdict'
}

const dropped = () => new DOMException('it was undone before it was sent', 'AbortError')

/**
 * Writes that a lost line must not lose: verdicts and comments. Each is kept in this browser before it is sent, and they
 * are sent in order, one at a time. A page that closes meanwhile leaves them to the next one of the same person.
 */
export class OfflineOutbox {
  #person = ''
  #writes: KeptWrite[] = []
  #count = 0
  #isUnreachable = false
  #isSending = false
  readonly #onTheirWay = new Map<KeptWrite, Promise<Response | null>>()
  /** Sent at least once: the server may have them, also where its answer was lost. */
  readonly #tried = new WeakSet<KeptWrite>()
  readonly #refusedKeys = new Set<string>()
  readonly #unkept = new Set<string>()
  readonly #asked = new Map<string, Asked>()

  /** Go on with what earlier pages of this person left. */
  begin(): void {
    const { personId } = outbox.writer
    if (personId !== this.#person) {
      this.#person = personId
      this.#writes = this.#stored<KeptWrite>(WAITING)
      outbox.show({ refused: this.#stored<RefusedWrite>(REFUSED) })
    }
    void this.#send()
  }

  /**
   * What sends a request of ours later where it must. `onKept` is called where it waits for the connection. One that
   * undoes another is given that one's key.
   */
  fetch =
    (label: string, onKept: () => void, undoes?: string) =>
    async (request: Request): Promise<Response> => {
      this.begin()
      const { pathname, search } = new URL(request.url)
      const write: KeptWrite = {
        place: `${String(Date.now()).padStart(15, '0')}-${String((this.#count += 1)).padStart(6, '0')}`,
        key: request.headers.get('Idempotency-Key') ?? newIdempotencyKey(),
        method: request.method,
        path: pathname + search,
        body: await request.text(),
        what: label,
        undoes,
      }
      if (undoes !== undefined && this.#refusedKeys.has(undoes)) throw dropped()
      this.#writes.push(write)
      this.#store(WAITING, write)
      const answer = new Promise<Response>((resolve, reject) =>
        this.#asked.set(write.place, { answer: resolve, drop: () => reject(dropped()), onKept, isKept: false }),
      )
      if (this.#isUnreachable || this.#isSending) {
        if (this.#isUnreachable) this.#sayKept()
        void this.#send()
      } else void this.#sendAtOnce(write) // lists that are read meanwhile see it sooner
      return answer
    }

  /** Forget a write that was not sent: its caller sees an AbortError. False where the server has it, or may have it. */
  drop(key: string): boolean {
    const write = this.#writes.find((kept) => kept.key === key)
    if (write === undefined || this.#tried.has(write) || !this.#isStored(write)) return false
    this.#forget(write)?.drop()
    this.#showWaiting()
    return true
  }

  forgetRefused(place: string): void {
    this.#unstore(REFUSED, place)
    outbox.show({ refused: outbox.getState().refused.filter((write) => write.place !== place) })
  }

  async #sendAtOnce(write: KeptWrite): Promise<void> {
    const sending = this.#answerBehind(write).catch(() => null)
    this.#onTheirWay.set(write, sending)
    const response = await sending
    this.#onTheirWay.delete(write)
    if (response === null || response.status === 429) await this.#send()
    else await this.#finish(write, response)
  }

  async #send(): Promise<void> {
    if (this.#isSending || this.#writes.every((write) => this.#onTheirWay.has(write))) return
    this.#isSending = true
    try {
      let isThere = false
      for (;;) {
        if (this.#onTheirWay.size > 0) await Promise.all(this.#onTheirWay.values())
        const next = this.#writes[0]
        if (next === undefined) break
        if (!this.#asked.has(next.place) && !this.#isStored(next)) {
          this.#forget(next) // another page of the person has sent or undone it
          continue
        }
        const response = await this.#answerTo(next, isThere)
        isThere = false
        if (response === null) {
          this.#isUnreachable = true
          this.#sayKept()
          await serverReturns()
          this.#isUnreachable = false
          isThere = true
        } else if (response.status === 429) await new Promise((resolve) => setTimeout(resolve, BUSY_MS))
        else if (response.status === 401 && this.#isLate(next))
          break // it is sent once the person has signed in
        else await this.#finish(next, response)
      }
    } finally {
      this.#isSending = false
    }
  }

  /** Nobody waits for the answer: an earlier page asked, or the person went on. */
  #isLate({ place }: KeptWrite): boolean {
    return this.#asked.get(place)?.isKept ?? true
  }

  /** The server's answer once what the write undoes was accepted; null where that was not. */
  async #answerBehind(write: KeptWrite): Promise<Response | null> {
    const undone = this.#writes.find(({ key }) => key === write.undoes)
    if (undone && !(await this.#onTheirWay.get(undone))?.ok) return null
    return this.#answerTo(write)
  }

  /** The server's answer; null where it was not reached. A browser that knows of no line is not asked to send. */
  async #answerTo(write: KeptWrite, isThere = false): Promise<Response | null> {
    if (!navigator.onLine && !isThere) return null
    this.#tried.add(write)
    const { key, method, path, body } = write
    const headers = {
      'Content-Type': 'application/json',
      'Idempotency-Key': key,
      'X-CSRF-Token': csrfToken() ?? '', // that of today's session
    }
    const url = new URL(path, globalThis.location.origin)
    try {
      return await send(new Request(url, { method, headers, body: body || undefined, credentials: 'same-origin' }))
    } catch (error) {
      if (error instanceof ApiProblem) return null
      throw error
    }
  }

  async #finish(write: KeptWrite, response: Response): Promise<void> {
    const isLate = this.#isLate(write)
    const asked = this.#forget(write)
    if (!response.ok) {
      this.#refusedKeys.add(write.key)
      for (const undo of this.#writes.filter(({ undoes }) => undoes === write.key)) this.#forget(undo)?.drop()
    }
    if (isLate && !response.ok) await this.#keepRefused(write, response.clone())
    this.#showWaiting()
    asked?.answer(response)
    if (isLate) outbox.writer.onLateAnswer()
  }

  #forget(write: KeptWrite): Asked | undefined {
    const asked = this.#asked.get(write.place)
    this.#asked.delete(write.place)
    this.#unstore(WAITING, write.place)
    this.#writes = this.#writes.filter((kept) => kept !== write)
    return asked
  }

  async #keepRefused({ place, what }: KeptWrite, response: Response): Promise<void> {
    const body: unknown = await response.json().catch(() => null)
    const refused = { place, what, why: problemOf(response.status, body).detail }
    this.#store(REFUSED, refused)
    outbox.show({ refused: [...outbox.getState().refused, refused] })
  }

  /** Let those who wait go on: their writes are kept. */
  #sayKept(): void {
    for (const asked of this.#asked.values()) {
      if (!asked.isKept) asked.onKept()
      asked.isKept = true
    }
    this.#showWaiting()
  }

  #showWaiting(): void {
    outbox.show({ waiting: this.#writes.filter((write) => this.#isLate(write)).map(kindOf) })
  }

  #stored<T extends { place: string }>(prefix: string): T[] {
    try {
      const mine = Object.entries({ ...localStorage }).filter(([key]) => key.startsWith(`${prefix}:${this.#person}:`))
      return mine.map(([, text]) => JSON.parse(String(text)) as T).sort((a, b) => a.place.localeCompare(b.place))
    } catch {
      return []
    }
  }

  #store(prefix: string, kept: { place: string }): void {
    try {
      localStorage.setItem(`${prefix}:${this.#person}:${kept.place}`, JSON.stringify(kept))
    } catch {
      this.#unkept.add(kept.place) // a browser that keeps nothing keeps it as long as the page stands
    }
  }

  /** Whether it is still kept in this browser. */
  #isStored({ place }: KeptWrite): boolean {
    try {
      return this.#unkept.has(place) || localStorage.getItem(`${WAITING}:${this.#person}:${place}`) !== null
    } catch {
      return true
    }
  }

  #unstore(prefix: string, place: string): void {
    try {
      localStorage.removeItem(`${prefix}:${this.#person}:${place}`)
    } catch {
      // It was not kept.
    }
  }
}

export const offlineOutbox = new OfflineOutbox()

/** The answer to a write; where it waits for the connection, what stands in its place until then. */
export const answerOrOptimistic = <T>(ask: (onKept: () => void) => Promise<T>, meanwhile: () => T): Promise<T> =>
  new Promise((resolve, reject) => {
    ask(() => resolve(meanwhile())).then(resolve, reject)
  })

const WAITING_ID = 'waiting-'
let waitingIds = 0

/** An id for what stands in the place of an answer. */
export const waitingId = (): string => `${WAITING_ID}${(waitingIds += 1)}`
export const isWaitingId = (id: string): boolean => id.startsWith(WAITING_ID)
