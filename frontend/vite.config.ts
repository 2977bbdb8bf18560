import { fileURLToPath } from 'node:url'

import react from '@vitejs/plugin-react'
import { defineConfig } from 'vitest/config'

import { chunkNames } from './scripts/chunks.ts'
import { PAGES, preload } from './scripts/preload.ts'
import { limitPageSizes } from './scripts/pageSizes.ts'
import { precompress } from './scripts/precompress.ts'

const server = process.env.SOUNDLIST_SERVER ?? 'http://127.0.0.1:8000'

const ARRIVALS = PAGES.map(({ modules: [page = ''] }) => page)

// Tests with vi.mock: a module that another file has loaded is no longer replaced.
const REPLACES_MODULES = ['src/features/take/DryStem.test.tsx', 'src/features/take/SourceBank.test.tsx']

export default defineConfig({
  plugins: [react(), preload(), precompress(), limitPageSizes(ARRIVALS)],
  resolve: { alias: { '@': fileURLToPath(new URL('./src', import.meta.url)) } },
  server: {
    host: '127.0.0.1',
    port: 5173,
    // As objects: the short form would change the Host, and the server takes writes from its own page only.
    proxy: { '/v1': { target: server }, '/help': { target: server } },
    // The checks' pages lie beside the frontend, in docs/checks.
    fs: { allow: ['..'] },
  },
  preview: { host: '127.0.0.1', port: 4173 },
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // The application, and the API's documentation at /docs.
    rolldownOptions: {
      input: ['index.html', 'docs/index.html'],
      output: {
        codeSplitting: {
          includeDependenciesRecursively: false,
          groups: [{ name: chunkNames(fileURLToPath(new URL('./src/main.tsx', import.meta.url))) }],
        },
      },
    },
  },
  test: {
    environment: 'jsdom',
    setupFiles: ['src/test/setup.ts'],
    restoreMocks: true,
    maxWorkers: 2,
    // A fast test takes at most 1 s of a processor; on a loaded machine that was over 10 s. These only end what hangs.
    testTimeout: 120_000,
    hookTimeout: 120_000,
    tags: [{ name: 'slow', description: 'Left to `npm run test:slow`.' }],
    projects: [
      // Files share a page environment and modules: to load them for each doubled what the tests of screens cost.
      { extends: true, test: { name: 'logic', include: ['src/**/*.test.ts'], isolate: false } },
      {
        extends: true,
        test: { name: 'screens', include: ['src/**/*.test.tsx'], exclude: REPLACES_MODULES, isolate: false },
      },
      { extends: true, test: { name: 'alone', include: REPLACES_MODULES } },
    ],
  },
})
