import type { QueryClient } from '@tanstack/react-query'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { ANY_FILE, partsTransport, type Picked, tusTransport, type Upload, UploadQueue } from '@/uploads'

import { addReference, addVersion } from './api'
import { bodyOfPin, type Pin } from './pins'

/** What a file becomes: a reference with a pin, or the next version of one. */
export type Goal = { pin: Pin } | { referenceId: string }

/** Files on their way to the board of one project. They go on while other pages are looked at. */
class ReferenceUploads {
  readonly queue: UploadQueue
  readonly #client: QueryClient
  readonly #projectId: string
  readonly #goals = new WeakMap<File, Goal>()

  constructor(client: QueryClient, projectId: string) {
    this.#client = client
    this.#projectId = projectId
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ project_id: projectId, file_name: file.name }),
    }
    this.queue = new UploadQueue({
      accepts: ANY_FILE,
      atATime: 2,
      transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
      onFinished: ({ file }, uploadId) => this.#arrived(file, uploadId),
    })
    // What has arrived is on the board.
    this.queue.subscribe(() => {
      for (const { id, state } of this.queue.get()) if (state === 'finished') this.queue.dismiss(id)
    })
  }

  add(picked: readonly Picked[], goal: Goal): Promise<void> {
    for (const { file } of picked) this.#goals.set(file, goal)
    return this.queue.add(picked, JSON.stringify(goal))
  }

  async #arrived(file: File, uploadId: string): Promise<void> {
    const goal = this.#goals.get(file) ?? { pin: '' }
    if ('referenceId' in goal) await addVersion(goal.referenceId, { upload_id: uploadId })
    else await addReference(this.#projectId, { upload_id: uploadId, ...bodyOfPin(goal.pin) })
    await invalidate(this.#client, queryKeys.references(this.#projectId))
  }
}

const known = new Map<string, ReferenceUploads>()

/** The uploads of one person to one board, which outlive the page that started them. */
export function uploadsOf(client: QueryClient, projectId: string, personId: string): ReferenceUploads {
  const key = `${personId} ${projectId}`
  const uploads = known.get(key) ?? new ReferenceUploads(client, projectId)
  known.set(key, uploads)
  return uploads
}
