import { type APIRequestContext, type APIResponse, type BrowserContext, expect } from '@playwright/test'

type Method = 'GET' | 'POST' | 'PUT' | 'PATCH'

/** Send a request as the person in this browser would; a refusal fails the test. */
export async function send(context: BrowserContext, url: string, method: Method, data?: unknown): Promise<APIResponse> {
  const csrf = (await context.cookies(url)).find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
  const answer = await context.request.fetch(url, { method, data, headers: { 'X-CSRF-Token': csrf } })
  expect(answer.ok(), `${method} ${url}: ${answer.status()} ${answer.ok() ? '' : await answer.text()}`).toBe(true)
  return answer
}

/** Ask the server as the person in this browser would; a refusal fails the test. */
export async function ask<T>(context: BrowserContext, url: string, method: Method = 'GET', data?: unknown): Promise<T> {
  return (await (await send(context, url, method, data)).json()) as T
}

/** The bytes at an address. */
export async function bytesAt(request: APIRequestContext, url: string): Promise<Buffer> {
  const answer = await request.get(url)
  expect(answer.ok(), `GET ${url}: ${answer.status()}`).toBe(true)
  return answer.body()
}
