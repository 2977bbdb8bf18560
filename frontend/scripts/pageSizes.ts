import { readFile, stat } from 'node:fs/promises'
import { join, resolve } from 'node:path'

import type { Plugin } from 'vite'

/** The most that a page may load before it shows what it is for, compressed. */
export const MOST_BYTES = {
  /** Of a page where people arrive, with nothing in the browser's cache: a second at 1.6 Mbit/s. */
  arrival: { script: 200 * 1_024, style: 30_000 },
  /** Of a page that is opened from another one, which has loaded most of it. */
  other: { script: 256 * 1_024, style: 30_000 },
}

export interface Chunk {
  type: 'chunk' | 'asset'
  fileName: string
  imports?: readonly string[]
  moduleIds?: readonly string[]
  isDynamicEntry?: boolean
  facadeModuleId?: string | null
  viteMetadata?: { importedCss?: ReadonlySet<string> }
}

/** Return the files of these chunks, and of all that they import before they run. */
export function filesOf(starts: readonly string[], bundle: Record<string, Chunk>): Set<string> {
  const files = new Set<string>()
  const visit = (name: string) => {
    const chunk = bundle[name]
    if (chunk?.type !== 'chunk' || files.has(name)) return
    files.add(name)
    for (const css of chunk.viteMetadata?.importedCss ?? []) files.add(css)
    chunk.imports?.forEach(visit)
  }
  starts.forEach(visit)
  return files
}

interface PageSize {
  page: string
  script: number
  style: number
}

/** Return what each page loads, compressed: the files that every page has, and those of its own. */
export function pageSizes(
  everywhere: readonly string[],
  bundle: Record<string, Chunk>,
  bytesOf: (file: string) => number,
): PageSize[] {
  return Object.values(bundle).flatMap((chunk) => {
    const page = /\/src\/features\/(.+Page)\.tsx$/.exec(chunk.facadeModuleId ?? '')?.[1]
    if (!chunk.isDynamicEntry || page === undefined) return []
    const files = [...new Set([...everywhere, ...filesOf([...everywhere, chunk.fileName], bundle)])]
    const sum = (ending: string) =>
      files.filter((file) => file.endsWith(ending)).reduce((bytes, file) => bytes + bytesOf(file), 0)
    return [{ page, script: sum('.js'), style: sum('.css') }]
  })
}

/** Return a sentence for each page that loads more than it may. */
export function tooLarge(sizes: readonly PageSize[], arrivals: readonly string[]): string[] {
  return sizes.flatMap((size) => {
    const most = MOST_BYTES[arrivals.includes(size.page) ? 'arrival' : 'other']
    return (['script', 'style'] as const)
      .filter((kind) => size[kind] > most[kind])
      .map((kind) => `${size.page} loads ${size[kind]} bytes of ${kind}, compressed; the limit is ${most[kind]}`)
  })
}

/** Fail the build where a page loads more than it may. Runs after the files have been compressed. */
export function limitPageSizes(arrivals: readonly string[]): Plugin {
  let folder = ''
  let bundle: Record<string, Chunk> = {}
  return {
    name: 'limit-page-sizes',
    apply: (_, { command, mode }) => command === 'build' && mode === 'production',
    configResolved: ({ root, build }) => {
      folder = resolve(root, build.outDir)
    },
    writeBundle: (_, written) => {
      bundle = written
    },
    closeBundle: {
      sequential: true,
      order: 'post',
      handler: async () => {
        const html = await readFile(join(folder, 'index.html'), 'utf8')
        const everywhere = [...html.matchAll(/(?:href|src)="\/(assets\/[^"]+\.(?:js|css))"/g)].map(
          ([, file = '']) => file,
        )
        const names = new Set([...everywhere, ...Object.keys(bundle)])
        const bytes = new Map<string, number>()
        for (const name of names) {
          const path = join(folder, name)
          const { size } = await stat(`${path}.br`).catch(() => stat(path)) // small files are not compressed
          bytes.set(name, size)
        }
        const sizes = pageSizes(everywhere, bundle, (file) => bytes.get(file) ?? 0)
        const missing = arrivals.filter((arrival) => !sizes.some(({ page }) => page === arrival))
        if (missing.length > 0) throw new Error(`the build has no page ${missing.join(', ')}`)
        const found = tooLarge(sizes, arrivals)
        if (found.length > 0) throw new Error(found.join('\n'))
      },
    },
  }
}
