// Writes src/api/schema.gen.ts from the server's OpenAPI document; with --check, says whether it is what it would write.
import { readFileSync, writeFileSync } from 'node:fs'

import openapiTS, { astToString } from 'openapi-typescript'

const document = new URL('../openapi.json', import.meta.url)
const target = new URL('../src/api/schema.gen.ts', import.meta.url)

const types = `// Made from openapi.json by "npm run gen"; edits are lost.\n\n${astToString(await openapiTS(document))}`
if (!process.argv.includes('--check')) writeFileSync(target, types)
else if (readFileSync(target, 'utf8') !== types) {
  console.error('src/api/schema.gen.ts is not what openapi.json says: run make openapi')
  process.exit(1)
}
