import { readFileSync } from 'node:fs'

interface Schema {
  $ref?: string
  anyOf?: Schema[]
  oneOf?: Schema[]
  allOf?: Schema[]
  items?: Schema
  prefixItems?: Schema[]
  properties?: Record<string, Schema>
  additionalProperties?: boolean | Schema
}
type Responses = Record<string, { content?: Record<string, { schema?: Schema }> }>

const { paths, components } = JSON.parse(readFileSync('openapi.json', 'utf8')) as {
  paths: Record<string, Record<string, { responses?: Responses }>>
  components: { schemas: Record<string, Schema> }
}

/** Paths by their pattern; those without a parameter come first. */
const PATTERNS = Object.keys(paths)
  .sort((a, b) => a.split('{').length - b.split('{').length)
  .map((path) => ({ path, pattern: new RegExp(`^${path.replaceAll(/{\w+}/g, '[^/]+')}$`) }))

const isObject = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null

/** Return the alternatives of a schema, each without references. */
function shapesOf(schema: Schema): Schema[] {
  if (schema.$ref) return shapesOf(components.schemas[schema.$ref.split('/').at(-1) ?? ''] ?? {})
  const others = schema.anyOf ?? schema.oneOf ?? schema.allOf
  return others ? others.flatMap(shapesOf) : [schema]
}

/** Return the fields of a value that no shape of the schema has, as "cues.0.lenght". */
function unknownIn(value: unknown, schema: Schema, at: string): string[] {
  const shapes = shapesOf(schema)
  if (Array.isArray(value)) {
    const items = shapes.flatMap((shape) => shape.items ?? shape.prefixItems ?? [])
    return items.length === 0 ? [] : value.flatMap((item, index) => unknownIn(item, { anyOf: items }, `${at}.${index}`))
  }
  const objects = shapes.filter((shape) => shape.properties)
  if (!isObject(value) || objects.length === 0) return []
  if (shapes.some(({ properties, additionalProperties }) => !properties && additionalProperties !== false)) return []
  return Object.entries(value).flatMap(([name, field]) => {
    const known = objects.flatMap(({ properties }) => properties?.[name] ?? [])
    return known.length === 0 ? [`${at}.${name}`] : unknownIn(field, { anyOf: known }, `${at}.${name}`)
  })
}

/** Return the fields of an answer that the API's schema does not have: what a test answers is what the server does. */
export function unknownFields(method: string, pathname: string, status: number, body: unknown): string[] {
  const path = PATTERNS.find(({ path, pattern }) => pattern.test(pathname) && paths[path]?.[method.toLowerCase()])?.path
  const responses = path === undefined ? undefined : paths[path]?.[method.toLowerCase()]?.responses
  const contents = Object.entries(responses ?? {}).filter(([code]) => code.startsWith('2'))
  const schemas = contents.flatMap(([, { content }]) => content?.['application/json']?.schema ?? [])
  return status >= 300 || schemas.length === 0 ? [] : unknownIn(body, { anyOf: schemas }, '')
}
