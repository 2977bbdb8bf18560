import { readdir, readFile, stat, writeFile } from 'node:fs/promises'
import { join, resolve } from 'node:path'
import { promisify } from 'node:util'
import { brotliCompress, constants, gzip } from 'node:zlib'

import type { Plugin } from 'vite'

const TEXT = /\.(js|css|svg|json)$/
/** Below this a file fills one packet anyway; the server's limit is the same. */
const SMALLEST_BYTES = 1_000

const compressions = {
  br: (content: Buffer) =>
    promisify(brotliCompress)(content, { params: { [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY } }),
  gz: (content: Buffer) => promisify(gzip)(content, { level: constants.Z_BEST_COMPRESSION }),
}

/** Write every hashed asset a second and third time, compressed: app/core/web/compression.py sends what a browser takes. */
export function precompress(): Plugin {
  let folder = ''
  return {
    name: 'precompress',
    apply: (_, { command, mode }) => command === 'build' && mode === 'production',
    configResolved: ({ root, build }) => {
      folder = resolve(root, build.outDir, build.assetsDir)
    },
    closeBundle: async () => {
      for (const name of (await readdir(folder)).filter((one) => TEXT.test(one))) {
        const path = join(folder, name)
        if ((await stat(path)).size < SMALLEST_BYTES) continue
        const content = await readFile(path)
        for (const [ending, compress] of Object.entries(compressions)) {
          await writeFile(`${path}.${ending}`, await compress(content))
        }
      }
    },
  }
}
