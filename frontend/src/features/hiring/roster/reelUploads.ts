import type { QueryClient } from '@tanstack/react-query'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { ANY_FILE, partsTransport, tusTransport, type Upload, UploadQueue } from '@/uploads'

import { addSound } from './api'

const titleOf = (name: string): string =>
  name
    .replace(/\.[^.]*$/, '')
    .replaceAll('_', ' ')
    .slice(0, 120) || 'Reel'

function begun(client: QueryClient, entryId: string): UploadQueue {
  const where = {
    endpoint: '/v1/uploads',
    metadata: ({ file }: Upload) => ({ roster_entry_id: entryId, file_name: file.name }),
  }
  const queue = new UploadQueue({
    accepts: ANY_FILE,
    atATime: 2,
    transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
    onFinished: async ({ file }, uploadId) => {
      await addSound(entryId, uploadId, titleOf(file.name))
      await invalidate(client, queryKeys.rosterEntry(entryId), queryKeys.roster.all)
    },
  })
  // What has arrived is in the reel.
  queue.subscribe(() => {
    for (const { id, state } of queue.get()) if (state === 'finished') queue.dismiss(id)
  })
  return queue
}

const known = new Map<string, UploadQueue>()

/** The uploads to the reel of one designer on file, which outlive the page that started them. */
export function reelUploads(client: QueryClient, entryId: string): UploadQueue {
  const queue = known.get(entryId) ?? begun(client, entryId)
  known.set(entryId, queue)
  return queue
}
