import { Server, startDemo } from './server'

/** Start the two servers that all tests share: one with nobody on it, and the demo. The answer stops them. */
export default async function start(): Promise<() => Promise<void>> {
  const demo = process.env.E2E_DEMO_URL ? null : await startDemo()
  if (demo) Object.assign(process.env, { E2E_DEMO_URL: demo.url, E2E_DEMO_FOLDER: demo.folder })
  const server = await Server.start()
  process.env.E2E_SERVER_PORT = String(server.port)
  return async () => {
    await Promise.all([server.stop(), demo?.stop()])
  }
}
