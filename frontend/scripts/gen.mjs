// Writes src/api/schema.gen.ts from the server's OpenAPI document, unless it is there and made from the same document.
import { createHash } from 'node:crypto'
import { existsSync, readFileSync, utimesSync, writeFileSync } from 'node:fs'

const document = new URL('../openapi.json', import.meta.url)
const target = new URL('../src/api/schema.gen.ts', import.meta.url)

const source = readFileSync(document)
const hash = createHash('sha256').update(source).digest('hex')
const header = `// Made by "npm run gen" from the openapi.json with the SHA-256 ${hash}; edits are lost.\n`

if (existsSync(target) && readFileSync(target, 'utf8').startsWith(header)) {
  utimesSync(target, new Date(), new Date()) // make compares times
} else {
  const { default: openapiTS, astToString } = await import('openapi-typescript')
  writeFileSync(target, `${header}\n${astToString(await openapiTS(source))}`)
}
