/** Judges files one after the other, away from the page. */
import { type Judgeable, judgeFile, type Judgement } from './judge'

export interface Order extends Judgeable {
  id: number
}

export interface Answer {
  id: number
  judgement: Judgement | null
}

let last: Promise<void> = Promise.resolve()

async function answer({ id, ...judgeable }: Order): Promise<void> {
  // A file that cannot be read here is left to the server.
  const judgement = await judgeFile(judgeable).catch(() => null)
  postMessage({ id, judgement } satisfies Answer)
}

addEventListener('message', ({ data }: MessageEvent<Order>) => {
  last = last.then(() => answer(data))
})
