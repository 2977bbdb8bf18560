import { type ChildProcess, spawn } from 'node:child_process'
import { randomBytes } from 'node:crypto'
import { once } from 'node:events'
import { existsSync } from 'node:fs'
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { type AddressInfo, createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { setTimeout as wait } from 'node:timers/promises'
import { fileURLToPath } from 'node:url'

export const ROOT = fileURLToPath(new URL('../..', import.meta.url))
export const PYTHON = join(ROOT, '.venv/bin/python')
const POLL_MS = 100
/** Seconds on a free machine: these bounds are for one that does much else. */
const STARTED_WITHIN_MS = 400_000
export const DEMO_MADE_WITHIN_MS = 600_000

/** A port of 127.0.0.1 that nobody listens on. */
export async function freePort(): Promise<number> {
  const probe = createServer().listen(0, '127.0.0.1')
  await once(probe, 'listening')
  const { port } = probe.address() as AddressInfo
  probe.close()
  await once(probe, 'close')
  return port
}

/** Come back once the condition holds; say what was awaited if it never does. */
export async function until(
  what: string,
  condition: () => Promise<boolean> | boolean,
  withinMs = STARTED_WITHIN_MS,
): Promise<void> {
  const deadline = Date.now() + withinMs
  while (!(await condition())) {
    if (Date.now() > deadline) throw new Error(`${what}: not within ${withinMs / 1000} s`)
    await wait(POLL_MS)
  }
}

export async function answers(url: string): Promise<boolean> {
  try {
    return (await fetch(url)).ok
  } catch {
    return false
  }
}

/** A process of the server, with what it last said for whoever asks why it died. */
class Running {
  readonly #child: ChildProcess
  #said = ''

  constructor(command: readonly string[], environment: Record<string, string>) {
    this.#child = spawn(PYTHON, ['-m', 'app', ...command], { cwd: ROOT, env: { ...process.env, ...environment } })
    for (const stream of [this.#child.stdout, this.#child.stderr]) {
      stream?.on('data', (chunk: Buffer) => {
        this.#said = (this.#said + chunk.toString()).slice(-4_000)
      })
    }
  }

  ensureAlive(): void {
    if (this.#hasEnded()) throw new Error(`the server ended by itself: ${this.#said}`)
  }

  async end(signal: NodeJS.Signals): Promise<void> {
    if (this.#hasEnded()) return
    const ended = once(this.#child, 'exit')
    this.#child.kill(signal)
    await ended
  }

  /** Come back when it has done its work. */
  async done(): Promise<void> {
    if (!this.#hasEnded()) await once(this.#child, 'exit')
    if (this.#child.exitCode !== 0) throw new Error(this.#said)
  }

  #hasEnded(): boolean {
    return this.#child.exitCode !== null || this.#child.signalCode !== null
  }
}

/** Soundlist as a studio runs it: web process and worker on the embedded database, in a folder of its own. */
export class Server {
  /** The address that people open. */
  readonly url: string
  readonly port: number
  readonly #folder: string
  readonly #environment: Record<string, string>
  #web: Running | undefined
  #worker: Running | undefined

  private constructor(port: number, folder: string, url: string, more: Record<string, string>) {
    this.port = port
    this.#folder = folder
    this.url = url
    this.#environment = {
      PYTHONPATH: ROOT,
      SOUNDLIST_DATA_DIR: folder,
      SOUNDLIST_BASE_URL: this.url,
      SOUNDLIST_SECRET_KEY: randomBytes(32).toString('hex'),
      SOUNDLIST_SIGN_UP: 'open',
      ...more,
    }
  }

  static async start({ port, url, more = {} }: { port?: number; url?: string; more?: Record<string, string> } = {}) {
    const listensOn = port ?? (await freePort())
    const folder = await mkdtemp(join(tmpdir(), 'soundlist-e2e-'))
    const server = new Server(listensOn, folder, url ?? `http://127.0.0.1:${listensOn}`, more)
    await new Running(['migrate'], server.#environment).done()
    server.#worker = new Running(['worker'], server.#environment)
    await server.startWeb().catch(async (error: unknown) => {
      await server.stop()
      throw error
    })
    return server
  }

  async startWeb(): Promise<void> {
    const web = new Running(['serve', '--port', String(this.port)], this.#environment)
    this.#web = web
    await until(`the server on port ${this.port} answers`, () => {
      web.ensureAlive()
      return answers(`http://127.0.0.1:${this.port}/readyz`)
    })
  }

  /** What a power cut does to the web process. */
  async killWeb(): Promise<void> {
    await this.#web?.end('SIGKILL')
  }

  async stop(): Promise<void> {
    await Promise.all([this.#web?.end('SIGTERM'), this.#worker?.end('SIGTERM')])
    await rm(this.#folder, { recursive: true, force: true })
  }
}

/** The server that the tests of a run share. */
export interface SharedServer {
  url: string
  port: number
}

export function sharedServer(): SharedServer {
  const port = Number(process.env.E2E_SERVER_PORT)
  return { url: `http://127.0.0.1:${port}`, port }
}

/** The demo, which makes its project while other tests run. */
export interface Demo {
  url: string
  projectId: string
  token: string
}

export async function startDemo(): Promise<{ url: string; folder: string; stop: () => Promise<void> }> {
  const port = await freePort()
  const folder = await mkdtemp(join(tmpdir(), 'soundlist-demo-'))
  const running = new Running(['demo', '--port', String(port)], { PYTHONPATH: ROOT, SOUNDLIST_DATA_DIR: folder })
  return {
    url: `http://127.0.0.1:${port}`,
    folder,
    stop: async () => {
      await running.end('SIGTERM')
      await rm(folder, { recursive: true, force: true })
    },
  }
}

/** The demo of this run, once its project is complete. */
export async function demoReady(): Promise<Demo> {
  const { E2E_DEMO_URL: url = '', E2E_DEMO_FOLDER: folder = '' } = process.env
  const made = join(folder, 'demo.json')
  await until('the demo project is made', () => existsSync(made), DEMO_MADE_WITHIN_MS)
  const { project, token } = JSON.parse(await readFile(made, 'utf8')) as { project: string; token: string }
  return { url, projectId: project, token }
}
