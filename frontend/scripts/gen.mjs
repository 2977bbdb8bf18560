// Writes src/api/schema.gen.ts from the server's OpenAPI document.
import { existsSync, writeFileSync } from 'node:fs'

import openapiTS, { astToString } from 'openapi-typescript'

const document = new URL('../openapi.json', import.meta.url)
const target = new URL('../src/api/schema.gen.ts', import.meta.url)

if (!existsSync(document)) {
  console.log('frontend/openapi.json is not there; the types stay as they are.')
  process.exit(0)
}
const types = astToString(await openapiTS(document))
writeFileSync(target, `// Made from openapi.json by "npm run gen"; edits are lost.\n\n${types}`)
