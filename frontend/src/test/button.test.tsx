import { QueryClient, QueryClientProvider } from '@tanstack/react-query'
import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { useMutation } from '@/api'
import { Button } from '@/ui/Button'

import { draw } from './draw'

test('a button is pressed once while what it began waits, without being told, and again after the answer', async () => {
  const answers: (() => void)[] = []
  function Send() {
    const send = useMutation({ mutationFn: () => new Promise<void>((resolve) => answers.push(resolve)) })
    return <Button onClick={() => send.mutate()}>Send</Button>
  }
  draw(
    <QueryClientProvider client={new QueryClient()}>
      <Send />
    </QueryClientProvider>,
  )
  const button = screen.getByRole('button', { name: 'Send' })
  await userEvent.click(button)
  expect(button).toHaveAttribute('aria-busy', 'true')
  await userEvent.click(button)
  expect(answers).toHaveLength(1)
  answers[0]?.()
  await waitFor(() => expect(button).not.toHaveAttribute('aria-busy'))
  await userEvent.click(button)
  expect(answers).toHaveLength(2)
})

test('a button that is said to wait neither acts nor sends its form, and keeps the focus', async () => {
  const act = vi.fn()
  const send = vi.fn()
  draw(
    <form onSubmit={send}>
      <Button type="submit" aria-busy onClick={act}>
        Issue
      </Button>
    </form>,
  )
  const button = screen.getByRole('button', { name: 'Issue' })
  await userEvent.click(button)
  expect(act).not.toHaveBeenCalled()
  expect(send).not.toHaveBeenCalled()
  expect(button).toHaveFocus()
})
