import { type ChildProcessByStdio, spawn } from 'node:child_process'
import { once } from 'node:events'
import { createInterface } from 'node:readline'
import type { Readable, Writable } from 'node:stream'

import { PYTHON, ROOT } from './server'

/** A PostgreSQL server of the test's own, with an empty database. */
export class Database {
  private constructor(
    readonly url: string,
    private readonly child: ChildProcessByStdio<Writable, Readable, null>,
  ) {}

  static async start(): Promise<Database> {
    const child = spawn(PYTHON, ['-m', 'tests.support.postgres'], { cwd: ROOT, stdio: ['pipe', 'pipe', 'inherit'] })
    const said = createInterface({ input: child.stdout })
    const first = await Promise.race([once(said, 'line'), once(child, 'exit').then(() => [])])
    if (typeof first[0] !== 'string') throw new Error('PostgreSQL did not start: make .make/postgresql')
    return new Database(first[0], child)
  }

  async stop(): Promise<void> {
    const ended = once(this.child, 'exit')
    this.child.stdin.end()
    await ended
  }
}
