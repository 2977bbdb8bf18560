import { csrfToken, problemOf, signedInAgain } from '@/api'
import { ANY_FILE, smallFilesTransport, tusTransport, type Upload, UploadQueue } from '@/uploads'

const encoded = (text: string) => btoa(String.fromCharCode(...new TextEncoder().encode(text)))

/** Send a whole file in one request. */
async function sendWhole(adoptionId: string, { file }: Upload, signal: AbortSignal): Promise<string> {
  const response = await fetch('/v1/uploads', {
    method: 'POST',
    body: file,
    signal,
    headers: {
      'Content-Type': 'application/offset+octet-stream',
      'Tus-Resumable': '1.0.0',
      'Upload-Length': String(file.size),
      'Upload-Metadata': `adoption_id ${encoded(adoptionId)},file_name ${encoded(file.name)}`,
      'X-CSRF-Token': csrfToken() ?? '',
    },
  })
  if (response.ok) return response.headers.get('Location')?.split('/').at(-1) ?? ''
  if (response.status === 401) void signedInAgain()
  const problem: unknown = await response.json().catch(() => null)
  throw problemOf(response.status, problem)
}

/** The queue that carries the files of one adoption. */
export function folderQueue(adoptionId: string): UploadQueue {
  const otherwise = tusTransport({
    endpoint: '/v1/uploads',
    metadata: ({ file }) => ({ adoption_id: adoptionId, file_name: file.name }),
  })
  return new UploadQueue({
    accepts: ANY_FILE,
    transport: smallFilesTransport({ send: (upload, signal) => sendWhole(adoptionId, upload, signal), otherwise }),
    onFinished: () => Promise.resolve(),
  })
}

const ENDED = ['finished', 'not_sent', 'stopped', 'already_here']

/** Send files and resolve once each has ended, with those that did not arrive. */
export async function sendAll(queue: UploadQueue, files: readonly { path: string; file: File }[]): Promise<Upload[]> {
  // By its path each file is another one, though two folders may have files of one name and size.
  for (const file of files) await queue.add([file], file.path)
  return new Promise((resolve) => {
    const settle = () => {
      const uploads = queue.get()
      if (!uploads.every(({ state }) => ENDED.includes(state))) return
      unsubscribe()
      resolve(uploads.filter(({ state }) => state !== 'finished'))
    }
    const unsubscribe = queue.subscribe(settle)
    settle()
  })
}
