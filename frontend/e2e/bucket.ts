import { type ChildProcess, execFile, spawn } from 'node:child_process'
import { once } from 'node:events'
import { mkdir, mkdtemp, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'

import { Line } from './line'
import { answers, freePort, ROOT, until } from './server'

const KEY = { id: 'soundlist-e2e', secret: 'only for tests' }

/** A real S3 server with one bucket, which browsers reach by a line that the test has in its hand. */
export class Bucket {
  readonly line: Line
  /** What a server is told that stores here. */
  readonly environment: Record<string, string>
  readonly #process: ChildProcess
  readonly #folder: string

  private constructor(process: ChildProcess, folder: string, port: number, line: Line) {
    this.line = line
    this.#process = process
    this.#folder = folder
    this.environment = {
      SOUNDLIST_STORE_URL: `s3://sounds/e2e?endpoint=http://127.0.0.1:${port}&public_endpoint=${line.url}`,
      SOUNDLIST_STORE_DIRECT: 'true',
      AWS_ACCESS_KEY_ID: KEY.id,
      AWS_SECRET_ACCESS_KEY: KEY.secret,
    }
  }

  static async start(pageUrl: string): Promise<Bucket> {
    const { stdout } = await promisify(execFile)(join(ROOT, '.ci/s3'))
    const folder = await mkdtemp(join(tmpdir(), 'soundlist-s3-'))
    await mkdir(join(folder, 'buckets', 'sounds'), { recursive: true })
    await mkdir(join(folder, 'sidecar'))
    const port = await freePort()
    const options = ['--quiet', '--port', `127.0.0.1:${port}`, '--health', '/health', '--cors-allow-origin', pageUrl]
    const running = spawn(
      stdout.trim(),
      [...options, 'posix', '--sidecar', join(folder, 'sidecar'), join(folder, 'buckets')],
      { env: { ...process.env, ROOT_ACCESS_KEY: KEY.id, ROOT_SECRET_KEY: KEY.secret }, stdio: 'ignore' },
    )
    const line = await Line.open()
    line.leadTo(port)
    await until('the S3 server answers', () => answers(`http://127.0.0.1:${port}/health`))
    return new Bucket(running, folder, port, line)
  }

  async stop(): Promise<void> {
    this.line.close()
    const ended = once(this.#process, 'exit')
    this.#process.kill('SIGKILL')
    await ended
    await rm(this.#folder, { recursive: true, force: true })
  }
}
