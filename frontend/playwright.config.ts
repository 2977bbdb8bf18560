import { defineConfig } from '@playwright/test'

export default defineConfig({
  testDir: 'e2e',
  globalSetup: './e2e/setup.ts',
  workers: 2,
  timeout: 180_000, // of a whole walk, while other parts of the tests run beside it; what it waits for has bounds of its own
  // A shared machine stalls now and then; what needed a second try is listed as flaky.
  retries: process.env.CI ? 2 : 0,
  expect: { timeout: 20_000 },
  forbidOnly: true,
  reporter: [['list']],
  // The demo makes itself while the first ones run.
  projects: [
    {
      name: 'job',
      testMatch: [
        'main-job.spec.ts',
        'contract.spec.ts',
        'fix.spec.ts',
        'resume.spec.ts',
        'tray.spec.ts',
        'live.spec.ts',
        'clipInTime.spec.ts',
        'sessionInTime.spec.ts',
        'hiring.spec.ts',
        'nda.spec.ts',
        'offline.spec.ts',
        'spotting.spec.ts',
        'team.spec.ts',
        'walk.spec.ts',
        // Minutes each, beside other tests: `make test-all` walks them.
        ...(process.env.LONG_WALKS ? ['judging.spec.ts', 'leaving.spec.ts', 'worked-example.spec.ts'] : []),
      ],
    },
    { name: 'parts', testMatch: ['parts.spec.ts', 'heard.spec.ts', 'atOnce.spec.ts'] },
    {
      name: 'demo',
      testMatch: [
        'pages.spec.ts',
        'demo.spec.ts',
        'docs.spec.ts',
        'speed.spec.ts',
        ...(process.env.FIREFOX ? ['firefox.spec.ts'] : []),
      ],
    },
  ],
  use: {
    actionTimeout: 15_000,
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
