import { act, fireEvent, screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { afterEach, expect, test } from 'vitest'

import { draw } from '@/test/draw'

import { CopyButton } from './CopyButton'

type Commanded = { execCommand?: (command: string) => boolean }
afterEach(() => {
  delete (document as Commanded).execCommand
})

/** A page of plain HTTP: there is no clipboard, and the old command answers this. */
function overHttp(command?: (selected: string) => boolean) {
  const user = userEvent.setup()
  Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true })
  if (command) {
    ;(document as Commanded).execCommand = () => command((document.activeElement as HTMLTextAreaElement).value)
  }
  return user
}

test('a text is copied, which is said', async () => {
  const user = userEvent.setup()
  draw(<CopyButton text="slt_once" what="Token" aria-label="Copy secret" />)
  await user.click(screen.getByRole('button', { name: 'Copy secret' }))
  expect(await navigator.clipboard.readText()).toBe('slt_once')
  expect(screen.getByRole('status')).toHaveTextContent('Token copied.')
})

test('over plain HTTP the old command copies, by the keyboard too, and the focus stays', async () => {
  const copied: string[] = []
  const user = overHttp((selected) => copied.push(selected) > 0)
  let at = 1
  draw(<CopyButton text={() => `http://x/?at=${at++}`} what="Link" aria-label="Copy link" />)
  const button = screen.getByRole('button', { name: 'Copy link' })
  button.focus()
  await user.keyboard('{Enter}')
  await waitFor(() => expect(screen.getByRole('status')).toHaveTextContent('Link copied.'))
  expect(copied).toEqual(['http://x/?at=1'])
  expect(button).toHaveFocus()
})

test.each([['refuses', () => false] as const, ['is missing', undefined] as const])(
  'where the command %s, the text stands selected until the keys copied it',
  async (_, command) => {
    const user = overHttp(command)
    const { container } = draw(<CopyButton text="slt_once" what="Token" aria-label="Copy secret" />)
    await user.click(screen.getByRole('button', { name: 'Copy secret' }))
    const field = await screen.findByRole<HTMLTextAreaElement>('textbox', { name: 'Text to copy' })
    expect(screen.getByRole('status')).toHaveTextContent('This browser does not let the page copy. Press Ctrl+C.')
    expect(field).toHaveFocus()
    expect(field.value.slice(field.selectionStart, field.selectionEnd)).toBe('slt_once')
    expect((await axe.run(container)).violations.map(({ id }) => id)).toEqual([])
    fireEvent.copy(field)
    await waitFor(() => expect(screen.getByRole('status')).toHaveTextContent('Token copied.'))
    expect(screen.queryByRole('textbox')).not.toBeInTheDocument()
  },
)

test('Escape puts the selected text away', async () => {
  const user = overHttp()
  draw(<CopyButton text="slt_once" what="Token" aria-label="Copy secret" />)
  await user.click(screen.getByRole('button', { name: 'Copy secret' }))
  await screen.findByRole('textbox', { name: 'Text to copy' })
  act(() => screen.getByRole('textbox').focus())
  await user.keyboard('{Escape}')
  expect(screen.queryByRole('textbox')).not.toBeInTheDocument()
})
