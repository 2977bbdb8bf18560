import { once } from 'node:events'
import { type AddressInfo, connect, createServer, type Server as Listener, type Socket } from 'node:net'
import { pipeline, Transform } from 'node:stream'
import { setTimeout as wait } from 'node:timers/promises'

/** The line between a browser and the server: it can be slow, and it can be cut in the middle of a file. */
export class Line {
  readonly url: string
  /** How fast bytes go up. */
  bytesPerS = Infinity
  bytesDownPerS = Infinity
  /** How long they take, each way. */
  latencyMs = 0
  /** How many went up so far. */
  carriedBytes = 0
  readonly #listener: Listener
  readonly #sockets = new Set<Socket>()
  #port = 0
  #dead = false

  private constructor(listener: Listener) {
    this.#listener = listener
    this.url = `http://127.0.0.1:${(listener.address() as AddressInfo).port}`
    listener.on('connection', (socket) => this.#carry(socket))
  }

  static async open(): Promise<Line> {
    const listener = createServer().listen(0, '127.0.0.1')
    await once(listener, 'listening')
    return new Line(listener)
  }

  leadTo(port: number): void {
    this.#port = port
  }

  cut(): void {
    this.#dead = true
    for (const socket of this.#sockets) socket.destroy()
  }

  fix(): void {
    this.#dead = false
  }

  close(): void {
    this.cut()
    this.#listener.close()
  }

  #carry(near: Socket): void {
    if (this.#dead) {
      near.destroy()
      return
    }
    const far = connect(this.#port, '127.0.0.1')
    for (const socket of [near, far]) {
      this.#sockets.add(socket)
      socket.on('close', () => this.#sockets.delete(socket))
    }
    // Whichever end goes away takes the other with it.
    pipeline(
      near,
      this.#delay(),
      (source: AsyncIterable<Buffer>) => this.#slowedUp(source),
      far,
      () => near.destroy(),
    )
    pipeline(
      far,
      this.#delay(),
      (source: AsyncIterable<Buffer>) => this.#slowed(source, () => this.bytesDownPerS),
      near,
      () => far.destroy(),
    )
  }

  /** All that comes in goes out so much later, however much is on its way. */
  #delay(): Transform {
    const after = (act: () => void) => (this.latencyMs > 0 ? setTimeout(act, this.latencyMs) : act())
    return new Transform({
      transform(chunk: Buffer, _, done) {
        after(() => this.push(chunk))
        done()
      },
      flush: (done) => void after(done),
    })
  }

  async *#slowedUp(source: AsyncIterable<Buffer>): AsyncGenerator<Buffer> {
    for await (const chunk of this.#slowed(source, () => this.bytesPerS)) {
      yield chunk
      this.carriedBytes += chunk.length
    }
  }

  async *#slowed(source: AsyncIterable<Buffer>, bytesPerS: () => number): AsyncGenerator<Buffer> {
    for await (const chunk of source) {
      yield chunk
      if (Number.isFinite(bytesPerS())) await wait((chunk.length / bytesPerS()) * 1_000)
    }
  }
}
