import { type BrowserContext, expect, type Page, test } from '@playwright/test'

import { ask } from './api'

/** Of every account that the walks make. */
export const PASSWORD = 'quiet reactor hum'

/** An address of this test alone: on the server that tests share, an address has one account. */
export function addressOf(name: string): string {
  const { testId, retry } = test.info()
  return `${name}@${testId.slice(-8)}-${retry}.example`
}

/** One party's browser; what has no page of its own here is asked as its pages ask. */
export class Party {
  private constructor(
    readonly url: string,
    readonly context: BrowserContext,
    readonly page: Page,
  ) {}

  static async arrive(url: string, context: BrowserContext): Promise<Party> {
    await context.request.get(`${url}/v1/session`)
    return new Party(url, context, await context.newPage())
  }

  ask<T>(method: 'GET' | 'POST' | 'PUT', path: string, data?: unknown): Promise<T> {
    return ask<T>(this.context, `${this.url}/v1${path}`, method, data)
  }

  async upload(delivery: string, name: string, bytes: Buffer): Promise<string> {
    const csrf = (await this.context.cookies(this.url)).find((cookie) => cookie.name === 'soundlist_csrf')?.value ?? ''
    const answer = await this.context.request.put(`${this.url}/v1/uploads`, {
      params: { delivery_id: delivery, file_name: name },
      data: bytes,
      headers: { 'X-CSRF-Token': csrf, 'Content-Type': 'application/octet-stream' },
    })
    expect(answer.ok(), await answer.text()).toBe(true)
    return ((await answer.json()) as { upload_id: string }).upload_id
  }
}
