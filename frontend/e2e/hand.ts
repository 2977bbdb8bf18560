import { type Locator, type Page, test } from '@playwright/test'

/** One person's browser, which counts what they do in it. */
export class Hand {
  clicks = 0
  fields = 0
  keys = 0
  requests = 0

  constructor(readonly page: Page) {
    page.on('request', (request) => {
      if (new URL(request.url()).pathname.startsWith('/v1/')) this.requests += 1
    })
  }

  async click(what: Locator): Promise<void> {
    this.clicks += 1
    await what.click()
  }

  async type(field: Locator, text: string): Promise<void> {
    this.fields += 1
    await field.fill(text)
  }

  async press(key: string): Promise<void> {
    this.keys += 1
    await this.page.keyboard.press(key)
  }

  report(name: string): void {
    const description = `${this.clicks} clicks, ${this.fields} fields, ${this.keys} keys, ${this.requests} requests`
    test.info().annotations.push({ type: name, description })
    console.log(`${name}: ${description}`)
  }
}
