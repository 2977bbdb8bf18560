import { createHash } from 'node:crypto'
import { readFile, writeFile } from 'node:fs/promises'
import { join, resolve } from 'node:path'

import type { Plugin } from 'vite'

import { type Chunk, filesOf } from './pageSizes.ts'

interface Page {
  /** Addresses of the page, as a regular expression; its group is the project. */
  at: string
  /** Modules that draw it. */
  modules: readonly string[]
  /** What it asks the server for first, in the words of the page's own requests: another order of parameters is another address. */
  asks: readonly string[]
}

const SIGNED_IN = ['/v1/session', '/v1/me']
const OF_PROJECT = '^/projects/([0-9a-f-]{36})'
const QUEUE = '/v1/review-queue?project_id={project}&own=true'
const ofProject = (...lists: string[]) => lists.map((list) => `/v1/projects/{project}/${list}`)

export const PAGES: readonly Page[] = [
  { at: '^/sign-in$', modules: ['accounts/SignInPage'], asks: ['/v1/session'] },
  {
    at: `${OF_PROJECT}/review$`,
    modules: ['review/ReviewPage', 'review/ReviewStart'],
    asks: [...SIGNED_IN, QUEUE],
  },
  {
    at: `${OF_PROJECT}/review/`,
    modules: ['review/ReviewPage'],
    asks: [...SIGNED_IN, QUEUE],
  },
  {
    at: `${OF_PROJECT}/today$`,
    modules: ['today/TodayPage'],
    asks: [...SIGNED_IN, QUEUE, ...ofProject('today', 'next-steps', 'money')],
  },
  {
    at: `${OF_PROJECT}/desk$`,
    modules: ['desk/DeskPage'],
    asks: [
      ...SIGNED_IN,
      ...ofProject(
        'desk',
        'next-steps',
        'deliveries?limit=1',
        'money',
        'fixes',
        'spec',
        'takes?unmatched=true&limit=200',
      ),
    ],
  },
]

interface PreloadedPage {
  at: string
  asks: readonly string[]
  files: readonly string[]
}

/**
 * Load the files of the page at this address and ask for its data, while the script that every page needs is on its way.
 * It runs alone in the page, before anything else: it can use nothing from outside itself.
 */
export function preloadPage(pages: readonly PreloadedPage[]): void {
  const { pathname, origin } = globalThis.location
  const page = pages.find(({ at }) => new RegExp(at).test(pathname))
  if (page === undefined) return
  const project = new RegExp(page.at).exec(pathname)?.[1] ?? ''
  const answers = new Map<string, Promise<Response>>()
  const ask = (path: string) => {
    const answer = fetch(path, { credentials: 'same-origin' })
    answers.set(origin + path, answer)
    answer.catch(() => undefined) // the page says so, and asks again
    return answer
  }
  const askForCue = async (queue: Promise<Response>) => {
    const { items } = (await (await queue).clone().json()) as {
      items: { cue: { id: string }; takes: { draft_change: unknown }[] }[]
    }
    const first = items.find(({ takes }) => takes.some(({ draft_change: draft }) => draft === null))
    if (first) void ask(`/v1/cues/${first.cue.id}/review`)
  }
  const askForFix = async (desk: Promise<Response>) => {
    const { came_back: cameBack } = (await (await desk).clone().json()) as { came_back: { take_id: string }[] }
    if (cameBack[0]) void ask(`/v1/takes/${cameBack[0].take_id}/fix`)
  }
  for (const path of page.asks) {
    const answer = ask(path.replace('{project}', project))
    if (path.startsWith('/v1/review-queue') && pathname.endsWith('/review')) askForCue(answer).catch(() => undefined)
    if (path.endsWith('/desk')) askForFix(answer).catch(() => undefined)
  }
  for (const file of page.files) {
    const link = document.createElement('link')
    link.rel = file.endsWith('.css') ? 'preload' : 'modulepreload'
    if (file.endsWith('.css')) link.as = 'style'
    link.crossOrigin = ''
    link.href = file
    document.head.append(link)
  }
  Object.assign(globalThis, { soundlistPrefetched: { answers, atMs: performance.now() } })
}

/** Files of the chunks with these modules, and of what they import. */
function filesWith(modules: readonly string[], bundle: Record<string, Chunk>): string[] {
  const chunks = modules.map((module) => {
    const chunk = Object.values(bundle).find(({ moduleIds }) =>
      moduleIds?.some((id) => id.endsWith(`/src/features/${module}.tsx`)),
    )
    if (chunk === undefined) throw new Error(`no chunk has ${module}`)
    return chunk.fileName
  })
  return [...filesOf(chunks, bundle)].map((file) => `/${file}`)
}

/** Put what preloads a page into the script that runs before the first paint. */
export function preload(): Plugin {
  let folder = ''
  let script: { name: string; content: string } | null = null
  return {
    name: 'preload',
    apply: 'build',
    configResolved: ({ root, build }) => {
      folder = resolve(root, build.outDir)
    },
    transformIndexHtml: {
      order: 'post',
      handler: async (html, { bundle, path }) => {
        if (bundle === undefined || path !== '/index.html') return html
        const here = new Set([...html.matchAll(/(?:href|src)="([^"]+)"/g)].map(([, file]) => file))
        const pages = PAGES.map(({ at, asks, modules }) => ({
          at,
          asks,
          files: filesWith(modules, bundle as unknown as Record<string, Chunk>).filter((file) => !here.has(file)),
        }))
        const scheme = await readFile(new URL('../public/scheme.js', import.meta.url), 'utf8')
        const content = `${scheme};(${preloadPage.toString()})(${JSON.stringify(pages)})\n`
        const hash = createHash('sha256').update(content).digest('base64url').slice(0, 8)
        script = { name: `assets/preload-${hash}.js`, content }
        return html.replace('<script src="/scheme.js">', `<script src="/${script.name}">`)
      },
    },
    writeBundle: async () => {
      if (script) await writeFile(join(folder, script.name), script.content)
    },
  }
}
