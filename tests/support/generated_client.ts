// Signs in with a long address and a long password, as a program would whose client is generated from openapi.json.
import createClient from 'openapi-fetch'

import type { paths } from './schema.ts'

const client = createClient<paths>({ baseUrl: process.argv[2]! })
const { error, response } = await client.POST('/v1/sign-in', { body: { email: 'x'.repeat(300), password: 'x'.repeat(2000) } })
if (error === undefined) throw new Error(`signed in: ${response.status}`)

const status: number = error.status
const code: string = error.code
const fields: string[] = (error.errors ?? []).map(({ where, message }) => `${where}: ${message}`)
console.log(JSON.stringify({ status, code, fields, type: response.headers.get('Content-Type') }))
