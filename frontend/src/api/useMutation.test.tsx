import { QueryClient, QueryClientProvider } from '@tanstack/react-query'
import { act, render, screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { useState } from 'react'
import { expect, test, vi } from 'vitest'

import { useMutation } from './useMutation'

interface PartProps {
  answer: Promise<string>
  onSuccess: (text: string) => void
  onError: () => void
}

function Part({ answer, onSuccess, onError }: PartProps) {
  const send = useMutation({ mutationFn: () => answer })
  return (
    <button type="button" onClick={() => send.mutate(undefined, { onSuccess, onError })}>
      Send
    </button>
  )
}

function Page(props: PartProps) {
  const [gone, setGone] = useState(false)
  return (
    <QueryClientProvider client={new QueryClient()}>
      {gone ? null : <Part {...props} />}
      <button type="button" onClick={() => setGone(true)}>
        Take it away
      </button>
    </QueryClientProvider>
  )
}

async function pressedThenTakenAway() {
  const handlers = { onSuccess: vi.fn<(text: string) => void>(), onError: vi.fn() }
  let resolve: (text: string) => void = () => {}
  let reject: (error: Error) => void = () => {}
  const answer = new Promise<string>((heard, refused) => {
    resolve = heard
    reject = refused
  })
  render(<Page answer={answer} {...handlers} />)
  await userEvent.click(screen.getByRole('button', { name: 'Send' }))
  await userEvent.click(screen.getByRole('button', { name: 'Take it away' }))
  return { ...handlers, resolve, reject }
}

test('the answer is heard where the part that asked is gone', async () => {
  const { onSuccess, onError, resolve } = await pressedThenTakenAway()
  act(() => resolve('sent'))
  await waitFor(() => expect(onSuccess.mock.calls[0]?.[0]).toBe('sent'))
  expect(onError).not.toHaveBeenCalled()
})

test('so is a refusal', async () => {
  const { onSuccess, onError, reject } = await pressedThenTakenAway()
  act(() => reject(new Error('refused')))
  await waitFor(() => expect(onError).toHaveBeenCalledOnce())
  expect(onSuccess).not.toHaveBeenCalled()
})
