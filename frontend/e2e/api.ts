import { type APIRequestContext, type BrowserContext, expect } from '@playwright/test'

/** Ask the server as the person in this browser would; a refusal fails the test. */
export async function ask<T>(
  context: BrowserContext,
  url: string,
  method: 'GET' | 'POST' | 'PUT' | 'PATCH' = 'GET',
  data?: unknown,
): Promise<T> {
  const csrf = (await context.cookies(url)).find(({ name }) => name === 'soundlist_csrf')?.value ?? ''
  const answer = await context.request.fetch(url, { method, data, headers: { 'X-CSRF-Token': csrf } })
  expect(answer.ok(), `${method} ${url}: ${answer.status()} ${answer.ok() ? '' : await answer.text()}`).toBe(true)
  return (await answer.json()) as T
}

/** The bytes at an address. */
export async function bytesAt(request: APIRequestContext, url: string): Promise<Buffer> {
  const answer = await request.get(url)
  expect(answer.ok(), `GET ${url}: ${answer.status()}`).toBe(true)
  return answer.body()
}
