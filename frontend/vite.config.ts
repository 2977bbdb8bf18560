import { fileURLToPath } from 'node:url'

import react from '@vitejs/plugin-react'
import { defineConfig } from 'vitest/config'

const server = process.env.SOUNDLIST_SERVER ?? 'http://127.0.0.1:8000'

export default defineConfig({
  plugins: [react()],
  resolve: { alias: { '@': fileURLToPath(new URL('./src', import.meta.url)) } },
  server: {
    host: '127.0.0.1',
    port: 5173,
    // As objects: the short form would change the Host, and the server takes writes from its own page only.
    proxy: { '/v1': { target: server } },
    // The checks' pages lie beside the frontend, in docs/checks.
    fs: { allow: ['..'] },
  },
  preview: { host: '127.0.0.1', port: 4173 },
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    // The application, and the API's documentation at /docs.
    rollupOptions: { input: ['index.html', 'docs/index.html'] },
  },
  test: {
    environment: 'jsdom',
    include: ['src/**/*.test.{ts,tsx}'],
    setupFiles: ['src/test/setup.ts'],
    restoreMocks: true,
    // One page environment for all files of a process: a new one, and everything imported anew, costs half of the run.
    isolate: false,
    maxWorkers: 2,
    // Whole pages take long on a busy machine, and other parts of the tests run beside these.
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
})
