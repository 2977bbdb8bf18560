import { ApiProblem, networkError } from '@/api'

import type { Transport, Upload } from './queue'

/** Up to here a file is one request: sending it again costs little more than asking where it stood. */
export const SMALL_BYTES = 2 * 2 ** 20

interface SmallOptions {
  /** Sends a whole file and resolves with the id of its upload. */
  send: (upload: Upload, signal: AbortSignal) => Promise<string>
  /** What carries ZIPs and larger files. */
  otherwise: Transport
}

/** Sends each small sound in one request; one whose connection dropped goes by what resumes. */
export function smallFilesTransport({ send, otherwise }: SmallOptions): Transport {
  const lost = new WeakSet<File>()
  return {
    start(upload, events) {
      const { kind, file } = upload
      if (kind !== 'sound' || file.size > SMALL_BYTES || lost.has(file)) return otherwise.start(upload, events)
      const stopping = new AbortController()
      send(upload, stopping.signal).then(
        (uploadId) => {
          if (!stopping.signal.aborted) events.onFinished(uploadId)
        },
        (error: unknown) => {
          if (stopping.signal.aborted) return
          const { status, detail } = error instanceof ApiProblem ? error : networkError()
          // Of a connection too slow for the whole file at once, what came before must count.
          if (status === 0 || status === 408) lost.add(file)
          if (status === 0 || status >= 500 || [408, 409, 429].includes(status)) events.onLost()
          else events.onRefused(detail)
        },
      )
      return () => stopping.abort()
    },
  }
}
