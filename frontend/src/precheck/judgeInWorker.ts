import type { Judgeable, Judgement } from './judge'
import type { Answer, Order } from './worker'

export type Judge = (judgeable: Judgeable) => Promise<Judgement | null>

/** A worker that judges files; where it fails, every file is left to the server. */
export function judgeInWorker(): Judge {
  const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  const waiting = new Map<number, (judgement: Judgement | null) => void>()
  let isBroken = false
  let lastId = 0
  worker.addEventListener('message', ({ data: { id, judgement } }: MessageEvent<Answer>) => {
    waiting.get(id)?.(judgement)
    waiting.delete(id)
  })
  worker.addEventListener('error', () => {
    isBroken = true
    for (const resolve of waiting.values()) resolve(null)
    waiting.clear()
  })
  return (judgeable) =>
    new Promise((resolve) => {
      if (isBroken) return resolve(null)
      const id = ++lastId
      waiting.set(id, resolve)
      worker.postMessage({ ...judgeable, id } satisfies Order)
    })
}
