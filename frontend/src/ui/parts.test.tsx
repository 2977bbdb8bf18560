import { fireEvent, screen, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test, vi } from 'vitest'

import { draw } from '@/test/draw'

import { Button, ButtonLink } from './Button'
import { Card, CardHead } from './Card'
import { ListTable } from './Table'
import { EmptyState } from './EmptyState'
import { Avatar } from './Avatar'
import { FieldError } from './FieldError'
import { FilterChip } from './FilterChip'
import { Finding } from './Finding'
import { Key } from './Key'
import { KeysLine } from './KeysLine'
import { Meter } from './Meter'
import { ErrorBanner } from './ErrorBanner'
import { Segmented } from './Segmented'
import { SetBlocks } from './SetBlocks'
import { StatusBadge, STATES, type StateKind } from './StatusBadge'
import { VerdictBar } from './VerdictBar'

describe('State', () => {
  test.each(Object.entries(STATES))('%s says its word beside its sign', (kind, { word, tone }) => {
    draw(<StatusBadge kind={kind as StateKind} />)
    const chip = screen.getByText(word).parentElement
    expect(chip).toHaveClass(`tone-${tone}`)
    expect(chip?.querySelector('svg')).toHaveAttribute('aria-hidden', 'true')
  })

  test('other words take the place of its own', () => {
    draw(<StatusBadge kind="accepted">5 of 8 accepted</StatusBadge>)
    expect(screen.getByText('5 of 8 accepted')).toBeInTheDocument()
    expect(screen.queryByText('Accepted')).not.toBeInTheDocument()
  })

  test('the reason of a waiver is there for those who focus it', async () => {
    draw(<StatusBadge kind="waived" reason="Flat tops are style here." />)
    const state = await screen.findByRole('button', { name: 'Waived: Flat tops are style here.' })
    await userEvent.tab()
    expect(state).toHaveFocus()
    expect(await screen.findByRole('tooltip')).toHaveTextContent('Flat tops are style here.')
  })
})

describe('Button', () => {
  test('names its key to assistive technology and draws its cap', () => {
    draw(
      <Button keys="a" icon="tick">
        Approve
      </Button>,
    )
    const button = screen.getByRole('button', { name: 'Approve' })
    expect(button).toHaveAttribute('aria-keyshortcuts', 'a')
    expect(within(button).getByText('a')).toHaveAttribute('aria-hidden', 'true')
  })

  test('is not a submit button unless it says so', () => {
    draw(<Button>Cut</Button>)
    expect(screen.getByRole('button')).toHaveAttribute('type', 'button')
  })

  test('stays down when pressed', () => {
    draw(<Button pressed>Loop</Button>)
    expect(screen.getByRole('button', { name: 'Loop', pressed: true })).toBeInTheDocument()
  })

  test('a link looks like one and is one', () => {
    draw(<ButtonLink href="/pack.zip">Download</ButtonLink>)
    expect(screen.getByRole('link', { name: 'Download' })).toHaveAttribute('href', '/pack.zip')
  })
})

test('a sequence has one cap a press', () => {
  const { container } = draw(<Key keys="g t" />)
  expect([...container.querySelectorAll('kbd')].map((cap) => cap.textContent)).toEqual(['g', 't'])
})

test('a line of keys says them in words too, seven at most', () => {
  draw(<KeysLine keys={Array.from({ length: 9 }, (_, index) => ({ keys: [`${index}`], label: `thing ${index}` }))} />)
  expect(screen.getByText('thing 6')).toBeInTheDocument()
  expect(screen.queryByText('thing 7')).not.toBeInTheDocument()
})

test('a card head has its title, its count and its note', () => {
  draw(
    <Card aria-labelledby="then">
      <CardHead id="then" title="Then" count={5} end="the oldest last" />
    </Card>,
  )
  const card = screen.getByRole('region', { name: 'Then' })
  expect(within(card).getByText('5')).toBeInTheDocument()
  expect(within(card).getByText('the oldest last')).toBeInTheDocument()
})

test('an empty state says what is so, what comes and what to do', () => {
  draw(
    <EmptyState head="Nothing to do" action={<Button>Hear the palette</Button>}>
      The next sounds are due on Friday.
    </EmptyState>,
  )
  expect(screen.getByRole('heading', { name: 'Nothing to do', level: 2 })).toBeInTheDocument()
  expect(screen.getByText('The next sounds are due on Friday.')).toBeInTheDocument()
  expect(screen.getByRole('button', { name: 'Hear the palette' })).toBeInTheDocument()
})

test('a finding names its severity, figure, place and what to do', () => {
  draw(
    <Finding severity="error" head="Sample peak 0.0 dBFS" where="0.418 s" actions={<Button>The spot</Button>}>
      The limit is −0.1.
    </Finding>,
  )
  const finding = screen.getByRole('article', { name: 'Sample peak 0.0 dBFS' })
  expect(finding).toHaveTextContent('Error: Sample peak 0.0 dBFS0.418 sThe limit is −0.1.The spot')
  expect(finding).toHaveClass('tone-bad')
})

test('a field error offers its correction with one press', async () => {
  const apply = vi.fn()
  draw(
    <FieldError correction={{ label: 'Use coolant_splash.wav', apply }}>
      Capitals and spaces do not match this project’s names.
    </FieldError>,
  )
  expect(screen.getByRole('alert')).toHaveTextContent('Capitals and spaces do not match this project’s names.')
  await userEvent.click(screen.getByRole('button', { name: 'Use coolant_splash.wav' }))
  expect(apply).toHaveBeenCalledOnce()
})

test('a refusal says what to do', () => {
  draw(<ErrorBanner detail="The delivery is closed." fix="Open a new one." />)
  expect(screen.getByRole('alert')).toHaveTextContent('The delivery is closed. Open a new one.')
})

test('a set counts what is here, one block a variation, the odd one marked', () => {
  const { container } = draw(
    <SetBlocks blocks={[{ tone: 'review' }, { tone: 'review' }, { tone: 'warn', odd: true }, { tone: 'idle' }]} />,
  )
  expect(screen.getByText('3 of 4')).toBeInTheDocument()
  expect(container.querySelectorAll('i')).toHaveLength(4)
  expect(container.querySelectorAll('i[data-odd]')).toHaveLength(1)
})

test('one of a few is on', async () => {
  const change = vi.fn()
  draw(
    <Segmented
      label="Listen to"
      value="master"
      onChange={change}
      options={[
        { value: 'master', label: 'Master' },
        { value: 'game', label: 'Game' },
      ]}
    />,
  )
  const group = screen.getByRole('group', { name: 'Listen to' })
  expect(within(group).getByRole('button', { pressed: true })).toHaveTextContent('Master')
  await userEvent.click(within(group).getByRole('button', { name: 'Game' }))
  expect(change).toHaveBeenCalledWith('game')
})

test('a filter says its state and how many it leaves', async () => {
  const press = vi.fn()
  draw(<FilterChip kind="to_review" count={4} pressed={false} onPress={press} />)
  await userEvent.click(screen.getByRole('button', { name: 'To review 4', pressed: false }))
  expect(press).toHaveBeenCalledOnce()
})

test('a meter says in words what it draws, and never overflows', () => {
  draw(<Meter label="3 of 10 accepted" whole={10} parts={[{ value: 3, tone: 'ok' }, { value: 0 }, { value: 20 }]} />)
  const bars = [...screen.getByRole('img', { name: '3 of 10 accepted' }).children]
  expect(bars.map((bar) => (bar as HTMLElement).style.width)).toEqual(['30%', '100%'])
})

test('the verdict bar says who decides and what follows', () => {
  draw(
    <VerdictBar who="You advise." follows="The audio director decides.">
      <Button variant="primary">I’d pick A</Button>
    </VerdictBar>,
  )
  const bar = screen.getByRole('region', { name: 'Verdict' })
  expect(bar).toHaveTextContent('You advise.The audio director decides.I’d pick A')
})

test.each([
  ['Audio director', 'AD'],
  ['Producer', 'PR'],
  ['Sound designer by contract', 'SD'],
])('%s has the face %s', (name, letters) => {
  draw(<Avatar name={name} />)
  expect(screen.getByText(letters)).toBeInTheDocument()
})

test('a face is the picture of the person, and letters where that does not load', () => {
  const { container } = draw(<Avatar name="Audio director" picture="/v1/people/p1/picture?sha256=ab" />)
  const picture = container.querySelector('img')
  expect(picture).toHaveAttribute('src', '/v1/people/p1/picture?sha256=ab')
  expect(picture).toHaveAttribute('alt', '') // the name stands beside it
  expect(screen.queryByText('AD')).not.toBeInTheDocument()
  if (picture) fireEvent.error(picture)
  expect(container.querySelector('img')).toBeNull()
  expect(screen.getByText('AD')).toBeInTheDocument()
})

describe('ListTable', () => {
  const columns = [
    { id: 'number', head: 'Number', cell: (row: { id: string; name: string }) => row.id },
    {
      id: 'name',
      head: 'Cue',
      narrow: 'name' as const,
      rowHead: true,
      cell: (row: { id: string; name: string }) => row.name,
    },
  ]
  const groups = [
    { id: 'alpha', head: 'Alpha', rows: [{ id: 'SW-007', name: 'shield_hit' }] },
    { id: 'beta', head: 'Beta', rows: [{ id: 'SW-018', name: 'warp_in' }] },
  ]

  test('names rows and groups, and marks the one in the hand', () => {
    draw(<ListTable label="Sound list" columns={columns} groups={groups} keyOf={(row) => row.id} selected="SW-018" />)
    const table = screen.getByRole('table', { name: 'Sound list' })
    expect(
      within(table)
        .getAllByRole('columnheader')
        .map((cell) => cell.textContent),
    ).toEqual(['Number', 'Cue'])
    expect(within(table).getByRole('rowheader', { name: 'Beta' })).toBeInTheDocument()
    expect(within(table).getByRole('row', { current: true })).toHaveTextContent('SW-018warp_in')
  })

  test('a press on a row takes it in the hand', async () => {
    const select = vi.fn()
    draw(<ListTable label="Sound list" columns={columns} groups={groups} keyOf={(row) => row.id} onSelect={select} />)
    await userEvent.click(screen.getByText('SW-007'))
    expect(select).toHaveBeenCalledWith({ id: 'SW-007', name: 'shield_hit' })
  })
})
