import { defineConfig } from '@playwright/test'

/** What takes minutes, measures time, or repeats another test on another database, in another role or size. */
const SLOW = /@slow/
/** The demo makes itself while the other tests run. */
const ON_DEMO = ['pages.spec.ts', 'demo.spec.ts', 'docs.spec.ts', 'speed.spec.ts']
const ON_FIREFOX = 'firefox.spec.ts'

export default defineConfig({
  testDir: 'e2e',
  globalSetup: './e2e/setup.ts',
  workers: 2,
  timeout: 600_000, // of a whole walk on a busy machine: it only ends what hangs
  expect: { timeout: 120_000 },
  forbidOnly: true,
  reporter: [['list']],
  // `npm run e2e` runs the first two, `npm run e2e:slow` the third, `npm run e2e:firefox` the last.
  projects: [
    { name: 'journeys', testIgnore: [...ON_DEMO, ON_FIREFOX], grepInvert: SLOW },
    { name: 'demo', testMatch: ON_DEMO, grepInvert: SLOW },
    { name: 'slow', testIgnore: ON_FIREFOX, grep: SLOW, retries: 1 }, // some of them measure time
    { name: 'firefox', testMatch: ON_FIREFOX },
  ],
  use: {
    contextOptions: { reducedMotion: 'reduce' }, // an animation that nobody watches is drawn all the same
    actionTimeout: 120_000,
    screenshot: 'only-on-failure',
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: [
        '--no-sandbox',
        '--disable-gpu',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--autoplay-policy=no-user-gesture-required',
      ],
    },
  },
})
