import { File as NodeFile } from 'node:buffer'

import type { Transport, TransportEvents, Upload } from '@/uploads/queue'

// jsdom's files cannot be read; Node's can.
export const File = NodeFile as unknown as typeof globalThis.File

export const bytes = (text: string, length = text.length) =>
  Uint8Array.from({ length }, (_, index) => (index < text.length ? text.charCodeAt(index) : 0))

export class HandTransport implements Transport {
  started: { upload: Upload; events: TransportEvents; stopped: boolean | null }[] = []

  start(upload: Upload, events: TransportEvents) {
    const one = { upload, events, stopped: null as boolean | null }
    this.started.push(one)
    return (forget: boolean) => {
      one.stopped = forget
    }
  }

  of(name: string) {
    const one = this.started.findLast(({ upload }) => upload.file.name === name)
    if (one === undefined) throw new Error(`${name} was not started`)
    return one
  }
}
