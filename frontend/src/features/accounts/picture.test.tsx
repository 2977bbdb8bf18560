import { fireEvent, screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

const ADDRESS = '/v1/people/x1/picture?sha256=ab'
const me = (picture: string | null) => ({
  person: { id: 'x1', name: 'Producer', picture },
  email: 'producer@studio.example',
  email_verified_at: null,
  studios: [],
  projects: [],
})

function openAccount(picture: string | null, more: Answers = {}) {
  const server = serve({
    'GET /v1/session': { signed_in: true, demo: false, person: me(picture).person },
    'GET /v1/me': me(picture),
    'GET /v1/me/sign-ins': [],
    ...more,
  })
  openApp('/account')
  return server
}

const card = async () => within(await screen.findByRole('region', { name: 'Picture' }))
const pictureIn = (within: Awaited<ReturnType<typeof card>>) =>
  within
    .getByText(/shown|see this/, { selector: 'p' })
    .closest('section')
    ?.querySelector('img')
const file = (name: string, size = 8) => new File([new Uint8Array(size)], name, { type: 'image/png' })

describe('the picture of a person', () => {
  test('is chosen, sent as it is, and shown', async () => {
    const server = openAccount(null, {
      'PUT /v1/me/picture': () => {
        server.answers['GET /v1/me'] = me(ADDRESS)
        return me(ADDRESS).person
      },
    })
    const inCard = await card()
    expect(inCard.getByText('PR')).toBeInTheDocument()
    await userEvent.upload(inCard.getByLabelText('Picture'), file('me.png'))
    expect(await inCard.findByRole('button', { name: 'Remove picture' })).toBeInTheDocument()
    expect(pictureIn(inCard)).toHaveAttribute('src', ADDRESS)
    const sent = server.asked.find(({ method }) => method === 'PUT')
    expect(sent?.headers.get('Content-Type')).toBe('application/octet-stream')
  })

  test('is dropped on the card', async () => {
    const server = openAccount(null, { 'PUT /v1/me/picture': me(ADDRESS).person })
    const inCard = await card()
    fireEvent.drop(inCard.getByText(/initials are shown/), { dataTransfer: { files: [file('me.png')] } })
    expect(await screen.findByText('This picture is shown beside your name now.')).toBeInTheDocument()
    expect(server.asked.filter(({ method }) => method === 'PUT')).toHaveLength(1)
  })

  test('is taken away', async () => {
    const server = openAccount(ADDRESS, {
      'DELETE /v1/me/picture': () => {
        server.answers['GET /v1/me'] = me(null)
        return null
      },
    })
    const inCard = await card()
    await userEvent.click(inCard.getByRole('button', { name: 'Remove picture' }))
    expect(await inCard.findByText('PR')).toBeInTheDocument()
  })

  test('what the server refuses is said in the card, and the old picture stays', async () => {
    openAccount(ADDRESS, {
      'PUT /v1/me/picture': refusal(422, 'picture-refused', 'this is a GIF; a PNG, JPEG or WebP picture is wanted', {
        fix: 'save it as a PNG or JPEG, then choose it again',
      }),
    })
    const inCard = await card()
    await userEvent.upload(inCard.getByLabelText('Picture'), file('me.png'))
    expect(await inCard.findByRole('alert')).toHaveTextContent(
      'This is a GIF; a PNG, JPEG or WebP picture is wanted. Save it as a PNG or JPEG, then choose it again.',
    )
    expect(pictureIn(inCard)).toHaveAttribute('src', ADDRESS)
  })

  test('what is too large, or more than one, is refused before it is sent', async () => {
    const server = openAccount(null)
    const inCard = await card()
    const line = inCard.getByText(/initials are shown/)
    fireEvent.drop(line, { dataTransfer: { files: [file('large.png', 10_000_001)] } })
    expect(inCard.getByRole('alert')).toHaveTextContent(
      'large.png has 10.0 MB. The limit is 10.0 MB. Make the picture smaller, then choose it again.',
    )
    fireEvent.drop(line, { dataTransfer: { files: [file('a.png'), file('b.png')] } })
    expect(inCard.getByRole('alert')).toHaveTextContent('2 files were dropped. Drop one picture.')
    expect(server.asked.some(({ method }) => method === 'PUT')).toBe(false)
  })
})
