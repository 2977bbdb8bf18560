import type { QueryClient } from '@tanstack/react-query'

import { ended } from '@/verdicts/findings'
import {
  type Accepts,
  partsTransport,
  type Picked,
  smallFilesTransport,
  tusTransport,
  type Upload,
  UploadQueue,
} from '@/uploads'

import {
  acceptedFilesQuery,
  addArchive,
  addFile,
  addTake,
  openDelivery,
  openDeliveryQuery,
  refresh,
  type TakeAdded,
} from './api'
import type { Precheck } from './precheck/precheck'
import { type RefusedFile, RefusedFiles } from './refused'

/** Of a thousand files each changes the lists; reading those again for each of them would keep the server busy. */
const REFRESH_EVERY_MS = 2_000
/** Longer for each file that came: the lists grow with them. */
const REFRESH_MS_EACH = 8

/** Files on their way into one project. They go on while other pages are looked at. */
export class DeliveryUploads {
  readonly queue: UploadQueue
  readonly refused: RefusedFiles
  /** What files go through before they are sent; null where the browser has no workers. */
  precheck: Precheck | null = null
  readonly #client: QueryClient
  readonly #projectId: string
  /** Which delivery a file was put into. */
  readonly #deliveryOf = new WeakMap<File, string>()
  /** The takes that finished uploads became, by the upload's id. */
  readonly #takes = new Map<string, TakeAdded>()
  /** Uploads that were made takes by the request that sent them. */
  readonly #made = new Set<string>()
  #opening: Promise<string> | null = null
  #refreshedAt = -Infinity
  #refreshing: ReturnType<typeof setTimeout> | undefined

  constructor(client: QueryClient, projectId: string, accepts: Accepts) {
    this.#client = client
    this.#projectId = projectId
    this.refused = new RefusedFiles(projectId)
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ delivery_id: this.#deliveryOf.get(file) ?? '', file_name: file.name }),
    }
    this.queue = new UploadQueue({
      accepts,
      transport: smallFilesTransport({
        send: (upload, signal) => this.#sendSmall(upload, signal),
        otherwise: partsTransport({ ...where, otherwise: tusTransport(where) }),
      }),
      onFinished: (upload, uploadId) => this.#arrived(upload, uploadId),
    })
    this.queue.subscribe(this.#keepRefused)
  }

  /** The take that an upload became, once its last byte was here. */
  takeOf = (uploadId: string): TakeAdded | undefined => this.#takes.get(uploadId)

  /** Load what judges files before they are sent, once; without it they are sent as they are. */
  async prepare(): Promise<Precheck | null> {
    if (typeof Worker === 'undefined') return null
    const loaded = await import('./precheck/precheck').catch(() => null)
    if (this.precheck === null && loaded !== null) {
      this.precheck = loaded.precheckOf(this.#projectId, this.queue, this.#send)
      this.precheck.subscribe(this.#keepRefused)
    }
    return this.precheck
  }

  /** Remove a file from the list that was refused on an earlier page. */
  forgetRefused(name: string): void {
    this.refused.forget(name, this.#refusedNow())
  }

  #keepRefused = (): void => {
    const dropped = [...this.queue.get(), ...(this.precheck?.get().held.map(({ picked }) => picked) ?? [])]
    this.refused.update(this.#refusedNow(), new Set(dropped.map(({ path }) => path)))
  }

  #refusedNow(): RefusedFile[] {
    const held = this.precheck?.get().held ?? []
    const notSent = this.queue.get().filter(({ state }) => state === 'not_sent')
    return [
      ...notSent.map(({ path, reason }) => ({ name: path, reason: reason ?? 'Refused.' })),
      ...held.map(({ picked, findings: [finding] }) => ({
        name: picked.path,
        reason: finding
          ? `${ended(finding.message)} ${ended(finding.auto_fix ? `fixable: a fix ${finding.auto_fix}` : finding.fix)}`
          : 'The name does not say which cue it is for.',
      })),
    ]
  }

  /** Put files into the open delivery; those that would come back wait for a decision. */
  async add(picked: readonly Picked[], cueId: string | null = null): Promise<void> {
    if (picked.length > 0) await (this.precheck?.add(picked, cueId) ?? this.#send(picked, cueId))
  }

  /** Send files into the open delivery, which is opened by the first of them. */
  #send = async (picked: readonly Picked[], cueId: string | null): Promise<void> => {
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

  async #sendSmall(upload: Upload, signal: AbortSignal): Promise<string> {
    const deliveryId = this.#deliveryOf.get(upload.file) ?? ''
    const { file, path, cueId } = upload
    const isRenamed = path.split('/').at(-1) !== file.name
    const named = { file_name: path, cue_id: cueId, ...(isRenamed ? { received_name: file.name } : {}) }
    this.#keep(upload, await addFile(deliveryId, file, named, signal))
    this.#made.add(upload.id)
    return upload.id
  }

  async #arrived(upload: Upload, uploadId: string): Promise<void> {
    const deliveryId = this.#deliveryOf.get(upload.file) ?? ''
    if (upload.kind === 'archive') {
      await addArchive(deliveryId, { upload_id: uploadId, file_name: upload.path })
    } else if (!this.#made.has(upload.id)) {
      const body = { upload_id: uploadId, file_name: upload.path, cue_id: upload.cueId, note: '' }
      this.#keep(upload, await addTake(deliveryId, body))
    }
    this.#refreshSoon()
  }

  /** A dry stem is no take; the delivery lists it. */
  #keep(upload: Upload, made: Awaited<ReturnType<typeof addTake>>): void {
    if ('state' in made) this.#takes.set(upload.id, made)
  }

  #refreshSoon(): void {
    const everyMs = REFRESH_EVERY_MS + REFRESH_MS_EACH * this.#takes.size
    const wait = Math.max(0, this.#refreshedAt + everyMs - performance.now())
    if (this.#refreshing !== undefined) return
    this.#refreshing = setTimeout(() => {
      this.#refreshing = undefined
      this.#refreshedAt = performance.now()
      void refresh(this.#client, this.#projectId)
    }, wait)
  }
}

const known = new Map<string, DeliveryUploads>()

/** The uploads of one person into one project, which outlive the page that started them. */
export async function uploadsOf(client: QueryClient, projectId: string, personId: string): Promise<DeliveryUploads> {
  const key = `${personId} ${projectId}`
  const accepts = await client.fetchQuery(acceptedFilesQuery(projectId))
  const uploads = known.get(key) ?? new DeliveryUploads(client, projectId, accepts)
  uploads.queue.accept(accepts)
  known.set(key, uploads)
  return uploads
}
