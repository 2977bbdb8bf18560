import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test, vi } from 'vitest'

import { ApiProblem } from '@/api/problem'
import { draw } from '@/test/draw'

import { Field, Form, Submit } from './Form'

interface Given {
  isPending?: boolean
  isSuccess?: boolean
  error?: unknown
  resets?: boolean
  send?: (values: { name: string; email: string }) => void
}

function Example({ isPending = false, isSuccess, error = null, resets, send = () => undefined }: Given) {
  return (
    <Form
      initialValues={{ name: '', email: '' }}
      mutation={{ isPending, isSuccess, error }}
      resets={resets}
      onSubmit={send}
    >
      <Field name="name" label="Your name" />
      <Field name="email" label="Email" type="email" />
      <Submit>Send</Submit>
    </Form>
  )
}

const refused = (...errors: { field: string; message: string }[]) =>
  new ApiProblem(422, { code: 'invalid', detail: 'a field does not match', fix: 'look at each field', errors })

async function fill() {
  await userEvent.type(screen.getByLabelText('Your name'), 'Ada')
  await userEvent.type(screen.getByLabelText('Email'), 'ada@hull')
}

test('what was refused stands below its field, takes the focus, and leaves as it is typed anew; nothing typed is lost', async () => {
  const page = draw(<Example />)
  await fill()
  page.rerender(<Example error={refused({ field: 'email', message: 'is no address' })} />)
  await waitFor(() => expect(screen.getByLabelText('Email')).toHaveAccessibleDescription('Is no address.'))
  expect(screen.getByLabelText('Email')).toHaveFocus()
  expect(screen.getByLabelText('Email')).toHaveValue('ada@hull')
  expect(screen.getByLabelText('Your name')).toHaveValue('Ada')
  expect(screen.queryByText(/A field does not match/)).toBeNull()
  await userEvent.type(screen.getByLabelText('Email'), '.example')
  expect(screen.queryByText('Is no address.')).toBeNull()
})

test('what was refused of no field in sight is said by the form', () => {
  draw(<Example error={refused({ field: 'setup_code', message: 'is missing' })} />)
  expect(screen.getByRole('alert')).toHaveTextContent('A field does not match. Look at each field.')
})

test('what was refused of a value without a field of its own is said by the form too', () => {
  draw(
    <Form
      initialValues={{ name: '', kind: 'cues' }}
      mutation={{ isPending: false, error: refused({ field: 'kind', message: 'is unknown' }) }}
      onSubmit={() => undefined}
    >
      <Field name="name" label="Your name" />
    </Form>,
  )
  expect(screen.getByRole('alert')).toHaveTextContent('A field does not match. Look at each field.')
})

test('while it is sent the button says so and nothing is sent again', async () => {
  const send = vi.fn()
  const page = draw(<Example send={send} />)
  await fill()
  await userEvent.keyboard('{Enter}')
  expect(send).toHaveBeenCalledExactlyOnceWith({ name: 'Ada', email: 'ada@hull' })
  page.rerender(<Example send={send} isPending />)
  expect(screen.getByRole('button', { name: 'Send' })).toHaveAttribute('aria-busy', 'true')
  await userEvent.click(screen.getByLabelText('Email'))
  await userEvent.keyboard('{Enter}')
  expect(send).toHaveBeenCalledOnce()
})

test('once sent it keeps what was typed, or empties itself where the next one is another', async () => {
  const page = draw(<Example />)
  await fill()
  page.rerender(<Example isSuccess />)
  expect(screen.getByLabelText('Your name')).toHaveValue('Ada')
  page.rerender(<Example isSuccess resets />)
  await waitFor(() => expect(screen.getByLabelText('Your name')).toHaveValue(''))
})
