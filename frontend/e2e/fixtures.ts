import { test as base } from '@playwright/test'

import { type Demo, demoReady, Server } from './server'

export const test = base.extend<{ server: Server }, { demo: Demo }>({
  /** A server of the test's own, with nobody on it yet. */
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names that a fixture needs from here
  server: async ({}, use) => {
    const server = await Server.start()
    await use(server)
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
