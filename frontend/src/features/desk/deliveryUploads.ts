import type { QueryClient } from '@tanstack/react-query'

import { partsTransport, type Picked, tusTransport, type Upload, UploadQueue } from '@/uploads'

import {
  acceptedKindsQuery,
  addArchive,
  addTake,
  keys,
  openDelivery,
  openDeliveryQuery,
  refresh,
  type TakeAdded,
} from './api'

/** Files on their way into one project. They go on while other pages are looked at. */
export class DeliveryUploads {
  readonly queue: UploadQueue
  readonly #client: QueryClient
  readonly #projectId: string
  /** Which delivery a file was put into. */
  readonly #deliveryOf = new WeakMap<File, string>()
  /** The takes that finished uploads became, by the upload's id. */
  readonly #takes = new Map<string, TakeAdded>()
  #opening: Promise<string> | null = null

  constructor(client: QueryClient, projectId: string, accepts: UploadQueueAccepts) {
    this.#client = client
    this.#projectId = projectId
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ delivery_id: this.#deliveryOf.get(file) ?? '', file_name: file.name }),
    }
    this.queue = new UploadQueue({
      accepts,
      transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
      onFinished: (upload, uploadId) => this.#arrived(upload, uploadId),
    })
  }

  /** The take that an upload became, once its last byte was here. */
  takeOf = (uploadId: string): TakeAdded | undefined => this.#takes.get(uploadId)

  /** Put files into the open delivery, which is opened by the first of them. */
  async add(picked: readonly Picked[], cueId: string | null = null): Promise<void> {
    if (picked.length === 0) return
    this.#opening ??= this.#openDelivery()
    try {
      const deliveryId = await this.#opening
      for (const { file } of picked) this.#deliveryOf.set(file, deliveryId)
    } finally {
      this.#opening = null
    }
    await this.queue.add(picked, cueId)
  }

  async #openDelivery(): Promise<string> {
    const known = await this.#client.fetchQuery({ ...openDeliveryQuery(this.#projectId), staleTime: 0 })
    if (known) return known.id
    const opened = await openDelivery(this.#projectId)
    this.#client.setQueryData(openDeliveryQuery(this.#projectId).queryKey, opened)
    return opened.id
  }

  async #arrived(upload: Upload, uploadId: string): Promise<void> {
    const deliveryId = this.#deliveryOf.get(upload.file) ?? ''
    if (upload.kind === 'archive') {
      await addArchive(deliveryId, { upload_id: uploadId, file_name: upload.path })
    } else {
      const body = { upload_id: uploadId, file_name: upload.path, cue_id: upload.cueId, note: '' }
      const made = await addTake(deliveryId, body)
      if ('state' in made) this.#takes.set(upload.id, made) // else it is a dry stem, which the delivery lists
    }
    void this.#client.invalidateQueries({ queryKey: keys.delivery(deliveryId) })
    void refresh(this.#client, this.#projectId)
  }
}

type UploadQueueAccepts = NonNullable<ConstructorParameters<typeof UploadQueue>[0]['accepts']>

const known = new Map<string, DeliveryUploads>()

/** The uploads of one person into one project, which outlive the page that started them. */
export async function uploadsOf(client: QueryClient, projectId: string, personId: string): Promise<DeliveryUploads> {
  const key = `${personId} ${projectId}`
  const accepts = await client.ensureQueryData(acceptedKindsQuery(projectId))
  const uploads = known.get(key) ?? new DeliveryUploads(client, projectId, accepts)
  known.set(key, uploads)
  return uploads
}
