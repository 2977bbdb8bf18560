import { useEffect, useState, useSyncExternalStore } from 'react'

import { connection } from '@/api'

import { filesOfDrop, type Picked } from './drops'
import type { Figures, Upload, UploadQueue } from './queue'

/** The rows of a queue and its figures, and notifies the queue when the connection is back. */
export function useUploads(queue: UploadQueue): { uploads: readonly Upload[]; figures: Figures; paused: boolean } {
  const uploads = useSyncExternalStore(queue.subscribe, queue.get)
  useEffect(() => {
    window.addEventListener('online', queue.lineIsBack)
    const unsubscribe = connection.subscribe(() => {
      if (!connection.isUnreachable()) queue.lineIsBack()
    })
    return () => {
      window.removeEventListener('online', queue.lineIsBack)
      unsubscribe()
    }
  }, [queue])
  return { uploads, figures: queue.figures(), paused: queue.isPaused() }
}

/** Ask before the page is closed while something is on its way. */
export function useLeaveWarning(uploads: readonly Upload[]): void {
  const going = uploads.some(({ state }) => state === 'sending' || state === 'waiting' || state === 'line_lost')
  useEffect(() => {
    if (!going) return
    const warn = (event: BeforeUnloadEvent) => event.preventDefault()
    window.addEventListener('beforeunload', warn)
    return () => window.removeEventListener('beforeunload', warn)
  }, [going])
}

/** The whole page takes drops; the answer is whether files hang over it. */
export function usePageDrop(onFiles: (picked: Picked[]) => void): boolean {
  const [over, setOver] = useState(false)
  useEffect(() => {
    let depth = 0
    const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') === true
    const enter = (event: DragEvent) => {
      if (!carriesFiles(event)) return
      event.preventDefault()
      depth += 1
      setOver(true)
    }
    const leave = (event: DragEvent) => {
      if (!carriesFiles(event)) return
      depth = Math.max(0, depth - 1)
      if (depth === 0) setOver(false)
    }
    const hang = (event: DragEvent) => {
      if (carriesFiles(event)) event.preventDefault()
    }
    const drop = (event: DragEvent) => {
      depth = 0
      setOver(false)
      // A cue's own drop place has taken it.
      if (event.defaultPrevented || event.dataTransfer === null || !carriesFiles(event)) return
      event.preventDefault()
      void filesOfDrop(event.dataTransfer).then(onFiles)
    }
    const listeners = { dragenter: enter, dragleave: leave, dragover: hang, drop }
    for (const [name, listener] of Object.entries(listeners)) window.addEventListener(name, listener as EventListener)
    return () => {
      for (const [name, listener] of Object.entries(listeners)) {
        window.removeEventListener(name, listener as EventListener)
      }
    }
  }, [onFiles])
  return over
}
