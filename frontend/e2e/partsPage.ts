import { type ChildProcess, spawn } from 'node:child_process'
import { once } from 'node:events'

import { answers, freePort, until } from './server'

const FOLDER = 'test-results/dist'

const vite = (...command: string[]): ChildProcess =>
  spawn(process.execPath, ['node_modules/vite/bin/vite.js', ...command], { stdio: 'ignore' })

/** Build the page that shows every part, which no released build has, and serve it. */
export async function servePartsPage(): Promise<{ url: string; stop: () => void }> {
  await once(vite('build', '--mode', 'test', '--outDir', FOLDER), 'exit')
  const port = String(await freePort())
  const preview = vite('preview', '--outDir', FOLDER, '--port', port, '--strictPort')
  const url = `http://127.0.0.1:${port}`
  await until('the page of parts answers', () => answers(url))
  return { url, stop: () => void preview.kill() }
}
