/* eslint-disable no-empty-pattern -- Playwright reads the names of what a fixture needs from its first parameter */
import { test as base } from '@playwright/test'

import { Bucket } from './bucket'
import { Database } from './database'
import { Line } from './line'
import { type Demo, DEMO_MADE_WITHIN_MS, demoReady, freePort, Server, type SharedServer, sharedServer } from './server'

interface Fixtures {
  server: SharedServer
  onPostgres: Server
  severalWeb: Server
  behindLine: { line: Line; server: Server }
  withBucket: { bucket: Bucket; server: Server }
}

export const test = base.extend<Fixtures, { demo: Demo }>({
  /** The server that tests share: each makes a studio of its own on it, with addresses of its own. */
  server: async ({}, use) => {
    await use(sharedServer())
  },
  /** A server of the test's own on PostgreSQL. */
  onPostgres: async ({}, use) => {
    const database = await Database.start()
    const server = await Server.start({ more: { SOUNDLIST_DATABASE_URL: database.url } })
    await use(server)
    await server.stop()
    await database.stop()
  },
  /** Such a server on PostgreSQL, answered by two web processes. */
  severalWeb: async ({}, use) => {
    const database = await Database.start()
    const more = { SOUNDLIST_DATABASE_URL: database.url, SOUNDLIST_WEB_PROCESSES: '2' }
    const server = await Server.start({ more })
    await use(server)
    await server.stop()
    await database.stop()
  },
  /** Such a server at the far end of a line that the test has in its hand. */
  behindLine: async ({}, use) => {
    const line = await Line.open()
    const server = await Server.start({ url: line.url })
    line.leadTo(server.port)
    await use({ line, server })
    line.close()
    await server.stop()
  },
  /** Such a server whose sounds are in a bucket that browsers reach by themselves. */
  withBucket: async ({}, use) => {
    const port = await freePort()
    const bucket = await Bucket.start(`http://127.0.0.1:${port}`)
    const server = await Server.start({ port, more: bucket.environment })
    await use({ bucket, server })
    await server.stop()
    await bucket.stop()
  },
  demo: [
    async ({}, use) => {
      await use(await demoReady())
    },
    { scope: 'worker', timeout: DEMO_MADE_WITHIN_MS + 10_000 },
  ],
})
