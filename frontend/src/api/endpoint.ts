import { queryOptions, type QueryKey, type UseQueryOptions } from '@tanstack/react-query'

import { unwrap, api } from './client'
import type { paths } from './schema.gen'

type Method = 'get' | 'post' | 'put' | 'patch' | 'delete'

/** The paths that have an operation of the method. */
type PathOf<M extends Method> = { [P in keyof paths]: paths[P][M] extends object ? P : never }[keyof paths]

type Named<T> = T extends object ? T : unknown
type Params<Op> = Op extends { parameters: { path?: infer Path; query?: infer Query } }
  ? Named<Path> & Named<Query>
  : never
type Body<Op> = Op extends { requestBody?: { content: infer Content } } ? Content[keyof Content] : undefined
type Content<Response> = Response extends { content: { 'application/json': infer Data } } ? Data : undefined
type Answer<Op> = Op extends { responses: infer R } ? Content<R[keyof R & (200 | 201 | 202 | 204)]> : never

/** What an endpoint is asked with: its parameters of path and query by name, then its body. Neither is given where there is none. */
type Asked<Op> =
  Body<Op> extends undefined
    ? object extends Params<Op>
      ? [params?: Params<Op>]
      : [params: Params<Op>]
    : undefined extends Body<Op>
      ? [params: Params<Op>, body?: Body<Op>]
      : [params: Params<Op>, body: Body<Op>]

const endpoint =
  <M extends Method>(method: M) =>
  <P extends PathOf<M>>(path: P, ...asked: Asked<paths[P][M]>): Promise<Answer<paths[P][M]>> => {
    const [params = {}, body] = asked as [params?: Record<string, unknown>, body?: unknown]
    const inPath: Record<string, unknown> = {}
    const query: Record<string, unknown> = {}
    for (const [name, value] of Object.entries(params)) (path.includes(`{${name}}`) ? inPath : query)[name] = value
    return unwrap(api.request(method, path as never, { params: { path: inPath, query }, body } as never))
  }

/** Ask an endpoint by its path in the API's schema, `get('/v1/takes/{take_id}', { take_id: id })`; a refusal is thrown. */
export const get = endpoint('get')
export const post = endpoint('post')
export const put = endpoint('put')
export const patch = endpoint('patch')
export const del = endpoint('delete')

type IdOf<P extends PathOf<'get'>> = paths[P]['get'] extends { parameters: { path: infer Path } } ? keyof Path : never
type Options<T> = Omit<UseQueryOptions<T, Error, T, QueryKey>, 'queryKey' | 'queryFn'>

/** Return the query of an endpoint whose path has one id, as a function of that id. */
export const queryById =
  <P extends PathOf<'get'>>(path: P, keyOf: (id: string) => QueryKey, options: Options<Answer<paths[P]['get']>> = {}) =>
  (id: string) => {
    const name = /{(\w+)}/.exec(path)?.[1] as IdOf<P> & string
    const asked = [{ [name]: id }] as unknown as Asked<paths[P]['get']>
    return queryOptions({ queryKey: keyOf(id), queryFn: () => get(path, ...asked), ...options })
  }
