import { fileURLToPath } from 'node:url'

import { build, type Rolldown } from 'vite'

/** The player and what measures its output, as one script for a page. */
export async function heardScript(): Promise<string> {
  const made = (await build({
    configFile: false,
    logLevel: 'silent',
    build: {
      write: false,
      minify: false,
      lib: { entry: fileURLToPath(new URL('heard.ts', import.meta.url)), name: 'heard', formats: ['iife'] },
    },
  })) as Rolldown.RolldownOutput[]
  return made[0]?.output[0].code ?? ''
}
