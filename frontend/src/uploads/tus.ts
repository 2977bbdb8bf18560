import type { DetailedError, Upload as TusUpload } from 'tus-js-client'

import { csrfToken, problemOf, signedInAgain } from '@/api'

import type { Transport, TransportEvents, Upload } from './queue'

export interface TusOptions {
  endpoint: string
  /** Sent once with the creation of each upload: what the server binds it to. */
  metadata: (upload: Upload) => Record<string, string>
}

export function bodyOf(text: string): unknown {
  try {
    return JSON.parse(text)
  } catch {
    return null
  }
}

function fail(error: Error | DetailedError, events: TransportEvents): void {
  const response = 'originalResponse' in error ? error.originalResponse : null
  const status = response?.getStatus() ?? 0
  if (status === 401) void signedInAgain()
  // A lock of the dropped connection expires in a moment, and a failing server comes back.
  if (status === 0 || status >= 500 || [401, 408, 409, 423, 429].includes(status)) events.onLost()
  else events.onRefused(problemOf(status, bodyOf(response?.getBody() ?? '')).detail)
}

/** Carries files by tus 1.0, and finds what was sent before, also after the page was closed. */
export function tusTransport({ endpoint, metadata }: TusOptions): Transport {
  return {
    start(upload, events) {
      let stopped = false
      const given = metadata(upload)
      const bound = JSON.stringify(given)
      let startAt: number | null = null
      let tus: TusUpload | null = null
      const options: TusUpload['options'] = {
        endpoint,
        metadata: { ...given, filename: upload.file.name },
        retryDelays: null,
        removeFingerprintOnSuccess: true,
        fingerprint: (file) =>
          Promise.resolve(
            ['soundlist', endpoint, bound, upload.path, file.size, upload.file.lastModified].map(String).join('|'),
          ),
        onBeforeRequest: (request) => {
          const token = csrfToken()
          if (token !== undefined) request.setHeader('X-CSRF-Token', token)
        },
        onAfterResponse: (request, response) => {
          if (request.getMethod() !== 'HEAD') return
          const offset = Number(response.getHeader('Upload-Offset') ?? 0)
          if (!stopped && offset > 0) events.onResumed(offset)
        },
        onProgress: (sent) => {
          if (stopped) return
          startAt ??= sent
          // The first figure after a return is where the server stands; only growth proves that the line holds.
          if (sent > startAt) events.onProgress(sent)
        },
        onError: (error) => {
          if (!stopped) fail(error, events)
        },
        onSuccess: () => {
          if (!stopped) events.onFinished(uploadIdOf(tus?.url ?? null))
        },
      }
      const isStopped = () => stopped
      const begin = async () => {
        // Small files, which most are, go without it.
        const { Upload: Tus } = await import('tus-js-client')
        if (isStopped()) return
        tus = new Tus(upload.file, options)
        const [last] = await tus.findPreviousUploads()
        if (last) tus.resumeFromPreviousUpload(last)
        if (!isStopped()) tus.start()
      }
      begin().catch(() => {
        if (!stopped) events.onLost()
      })
      return (forget) => {
        stopped = true
        void tus?.abort(forget).catch(() => undefined)
      }
    },
  }
}

/** The last part of an upload's address is its id. */
export function uploadIdOf(url: string | null): string {
  return (
    url
      ?.replace(/[?#].*$/, '')
      .replace(/\/+$/, '')
      .split('/')
      .at(-1) ?? ''
  )
}
