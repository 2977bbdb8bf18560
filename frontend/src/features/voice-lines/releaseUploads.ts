import type { QueryClient } from '@tanstack/react-query'

import { post } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { ANY_FILE, partsTransport, type Picked, tusTransport, type Upload, UploadQueue } from '@/uploads'

import type { ReleaseAdd } from './api'

/** Signed releases on their way to one project. They go on while other pages are looked at. */
class ReleaseUploads {
  readonly queue: UploadQueue
  readonly #goals = new WeakMap<File, Omit<ReleaseAdd, 'upload_id'>>()

  constructor(client: QueryClient, projectId: string) {
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ project_id: projectId, file_name: file.name }),
    }
    this.queue = new UploadQueue({
      accepts: ANY_FILE,
      atATime: 1,
      transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
      onFinished: async ({ file }, uploadId) => {
        const release = this.#goals.get(file)
        if (release === undefined) return
        await post(
          '/v1/projects/{project_id}/voice-releases',
          { project_id: projectId },
          { ...release, upload_id: uploadId },
        )
        await invalidate(client, queryKeys.voiceLines(projectId))
      },
    })
    // What has arrived is in the list of releases.
    this.queue.subscribe(() => {
      for (const { id, state } of this.queue.get()) if (state === 'finished') this.queue.dismiss(id)
    })
  }

  add(picked: readonly Picked[], release: Omit<ReleaseAdd, 'upload_id'>): Promise<void> {
    for (const { file } of picked) this.#goals.set(file, release)
    return this.queue.add(picked, JSON.stringify(release))
  }
}

export type { ReleaseUploads }

const known = new Map<string, ReleaseUploads>()

/** The uploads of one person to one project, which outlive the page that started them. */
export function releaseUploadsOf(client: QueryClient, projectId: string, personId: string): ReleaseUploads {
  const key = `${personId} ${projectId}`
  const uploads = known.get(key) ?? new ReleaseUploads(client, projectId)
  known.set(key, uploads)
  return uploads
}
