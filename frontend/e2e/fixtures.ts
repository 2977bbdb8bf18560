import { test as base } from '@playwright/test'

import { Line } from './line'
import { type Demo, demoReady, Server } from './server'

export const test = base.extend<{ server: Server; behindLine: { line: Line; server: Server } }, { demo: Demo }>({
  /** A server of the test's own, with nobody on it yet. */
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names that a fixture needs from here
  server: async ({}, use) => {
    const server = await Server.start()
    await use(server)
    await server.stop()
  },
  /** Such a server at the far end of a line that the test has in its hand. */
  // eslint-disable-next-line no-empty-pattern
  behindLine: async ({}, use) => {
    const line = await Line.open()
    const server = await Server.start(line.url)
    line.leadTo(server.port)
    await use({ line, server })
    line.close()
    await server.stop()
  },
  demo: [
    // eslint-disable-next-line no-empty-pattern
    async ({}, use) => {
      await use(await demoReady())
    },
    { scope: 'worker', timeout: 160_000 },
  ],
})
