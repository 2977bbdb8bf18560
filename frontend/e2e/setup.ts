import { spawn } from 'node:child_process'
import { once } from 'node:events'

import { answers, freePort, startDemo, until } from './server'

const PARTS_FOLDER = 'test-results/dist'

async function vite(...command: string[]): Promise<ReturnType<typeof spawn>> {
  const child = spawn(process.execPath, ['node_modules/vite/bin/vite.js', ...command], { stdio: 'ignore' })
  await once(child, 'spawn')
  return child
}

/** Start what all tests share, the demo and the page of parts; the answer stops it. */
export default async function start(): Promise<() => Promise<void>> {
  const demo = process.env.E2E_DEMO_URL ? null : await startDemo()
  const building = await vite('build', '--mode', 'test', '--outDir', PARTS_FOLDER)
  await once(building, 'exit')
  const port = String(await freePort())
  const parts = await vite('preview', '--outDir', PARTS_FOLDER, '--port', port, '--strictPort')
  const partsUrl = `http://127.0.0.1:${port}`
  await until('the page of parts answers', () => answers(partsUrl))
  process.env.E2E_PARTS_URL = partsUrl
  if (demo) Object.assign(process.env, { E2E_DEMO_URL: demo.url, E2E_DEMO_FOLDER: demo.folder })
  return async () => {
    parts.kill()
    await demo?.stop()
  }
}
