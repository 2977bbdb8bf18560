import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { aFinding, aMe, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'
import { aCheck, aGameFile, aFix, aVersion, DESIGNER, LATE, someSounds } from '@/test/take'
import { card, lastStarted, opened, server, serveTakePage } from '@/test/takePage'

beforeAll(() => import('./TakePage'))
serveTakePage()

describe('findings', () => {
  test('stand worst first, each with its limit, its place, what to do, its fix and its page', async () => {
    await opened()
    const list = await screen.findByRole('list', { name: 'Findings' })
    await waitFor(() => expect(within(list).getAllByRole('listitem')).toHaveLength(2))
    const [loud, late] = within(list).getAllByRole('listitem')
    expect(loud).toHaveTextContent('Error: Sample peak 0.00 dBFS')
    expect(loud).toHaveTextContent('Limit −0.1 dBFS. Lower the level by 0.10 dB or more.')
    expect(loud).toHaveTextContent('A fix lowers the level by 0.10 dB.')
    expect(loud).toHaveTextContent('0.418 s')
    expect(late).toHaveTextContent('Warning: 412.0 ms of silence before the sound')
    expect(within(list).getByRole('link', { name: /^sample-peak/ })).toHaveAttribute('href', '/checks/sample-peak')
  })

  test('one that no fix answers says why', async () => {
    server.on(
      'GET /v1/takes/t1/check',
      aCheck({ findings: [aFinding({ no_auto_fix: 'What was cut off at the top is gone.' })] }),
    )
    await opened()
    expect(await screen.findByText('What was cut off at the top is gone.')).toBeInTheDocument()
  })

  test('j takes the next one, Enter plays its spot', async () => {
    const user = userEvent.setup()
    await opened()
    const list = await screen.findByRole('list', { name: 'Findings' })
    await waitFor(() => expect(within(list).getAllByRole('listitem')).toHaveLength(2))
    await user.keyboard('j')
    expect(within(list).getAllByRole('listitem')[0]).toHaveAttribute('aria-current', 'true')
    await user.keyboard('{Enter}')
    // From 0.3 s before it.
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.118))
    await user.keyboard('k')
    expect(within(list).getAllByRole('listitem')[1]).toHaveAttribute('aria-current', 'true')
  })

  test('an address with a place plays from there', async () => {
    const user = userEvent.setup()
    await opened('/takes/t1?at=0.75')
    await within(await card('Sound')).findByRole('button', { name: /Play/ })
    await user.keyboard(' ')
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.75))
  })

  test('nothing found is said, and so is a check that is still to come', async () => {
    server
      .on('GET /v1/takes/t1', aVersion({ state: 'conforming' }))
      .on('GET /v1/takes/t1/check', aCheck({ findings: [], verdict: 'conforming' }))
      .on('GET /v1/takes/t1/fix', aFix({ state: 'none' }))
    await opened()
    expect(await screen.findByText('All checks passed.')).toBeInTheDocument()
    expect(screen.queryByRole('region', { name: 'Fix' })).not.toBeInTheDocument()
  })

  test('a version that was let through says by whom and why', async () => {
    const waiver = {
      id: 'w',
      codes: [LATE.code],
      reason: 'Meant so',
      waived_by: DESIGNER,
      created_at: '2026-11-20T10:00:00Z',
    }
    server.on('GET /v1/takes/t1/check', aCheck({ findings: [{ ...LATE, waived: true }], waiver }))
    await opened()
    expect(await screen.findByText(/Waived by the approver\./)).toBeInTheDocument()
    expect(await screen.findByText(': Meant so')).toBeInTheDocument()
  })
})

describe('figures and files', () => {
  test('every figure stands with its unit; what is over a limit is marked', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ measurements: { sample_peak_dbfs: 0, novel_slope_db: -3 } }))
    await opened()
    const figures = await card('Measurements')
    expect(within(figures).getByText('48 kHz')).toBeInTheDocument()
    expect(within(figures).getByText('0.0 dBFS')).toHaveTextContent('Error: 0.0 dBFS')
    expect(within(figures).getByText('Novel slope')).toBeInTheDocument()
    expect(within(figures).getByText('−3.0 dB')).toBeInTheDocument()
  })

  test('the spectrum of the whole sound says where it ends and where it is loudest', async () => {
    await opened()
    const spectrum = await card('Spectrum of the whole sound')
    expect(spectrum).toHaveTextContent('ends at 19 kHz')
    expect(spectrum).toHaveTextContent('Loudest near 1.0 kHz, −12.4 dBFS.')
  })

  test('a game file can be seen and heard in place of the master', async () => {
    const user = userEvent.setup()
    server.on(
      'GET /v1/takes/t1/sounds',
      someSounds({
        renders: [
          aGameFile({ attenuation_db: 0.43 }),
          aGameFile({
            target: 'handheld',
            state: 'refused',
            refusal: 'the target asks for more',
            preview_url: null,
            file_url: null,
          }),
        ],
      }),
    )
    await opened()
    const files = await card('Game files')
    expect(files).toHaveTextContent('44.1 kHz, 16 bit, mono, 70.0 kB, lowered by 0.43 dB to stay under the peak limit')
    expect(files).toHaveTextContent('The target asks for more')
    await user.click(screen.getByRole('button', { name: 'Game' }))
    await user.click(screen.getByRole('button', { name: /^Play(?! (original|fixed))/ }))
    await waitFor(() => expect(server.of('GET /v1/sounds/g1/preview')).toHaveLength(1))
  })

  test('where a contract opens files by payment, the master card says what opens them and offers no download', async () => {
    const closed = 'its files open when invoice INV-2026-014 is paid: USD 200.00 of it is open for this cue'
    server.on('GET /v1/takes/t1/sounds', someSounds({ closed, renders: [aGameFile({ file_url: null })] }))
    await opened()
    const master = await card('Master')
    await waitFor(() => expect(master).toHaveTextContent('Available after payment'))
    expect(master).toHaveTextContent('Its files open when invoice INV-2026-014 is paid')
    expect(within(master).queryByRole('link')).toBeNull()
    expect(within(master).queryByRole('button')).toBeNull()
    expect(within(await card('Game files')).queryByRole('link', { name: /Download/ })).toBeNull()
  })

  test('a file that cannot be read as a sound says so', async () => {
    server
      .on('GET /v1/takes/t1/sounds', {
        ...someSounds({ fix: null }),
        master: { ...someSounds().master, state: 'undrawable', duration_s: null, preview_url: null, peaks_url: null },
      })
      .on('GET /v1/takes/t1/check', aCheck({ verdict: 'unreadable', facts: null, measurements: {} }))
      .on('GET /v1/takes/t1/fix', aFix({ state: 'none' }))
    await opened()
    expect(await screen.findByText('No waveform: the file could not be read as audio.')).toBeInTheDocument()
    expect(screen.getByText('No measurements: the file could not be read.')).toBeInTheDocument()
  })
})

test('the ways lead to the cue, and for the team to the review room', async () => {
  server.on('GET /v1/me', aMe())
  await opened()
  expect(screen.getByRole('link', { name: 'Cue' })).toHaveAttribute('href', `/projects/${PROJECT}/sound-list/cues/c1`)
  expect(await screen.findByRole('link', { name: 'Open in review' })).toHaveAttribute(
    'href',
    `/projects/${PROJECT}/review/c1?take=t1`,
  )
})

test('a version that is not there says so', async () => {
  server.on('GET /v1/takes/t1', refusal(404, 'take-not-found', 'no take t1'))
  openApp('/takes/t1')
  expect(await screen.findByRole('heading', { level: 1, name: 'Version not found' })).toBeInTheDocument()
})

test('a version that an NDA keeps closed leads to the NDA', async () => {
  const me = aMe({ part: 'designer', is_liaison: false, is_approver: false, nda_open: true })
  server
    .on('GET /v1/me', me)
    .on('GET /v1/takes/t1', refusal(403, 'nda-needed', 'this project shows its brief once its NDA is accepted'))
    .on(`GET /v1/projects/${PROJECT}/contracts`, [
      { id: 'nda-1', kind: 'nda', state: 'sent', title: 'NDA', waits_for: ['designer', 'studio'] },
    ])
  const app = openApp('/takes/t1')
  expect(
    await screen.findByRole('heading', { level: 1, name: 'Read and sign the NDA to see this project' }),
  ).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Read the NDA' }))
  await waitFor(() => expect(app.at()).toBe(`/projects/${PROJECT}/contracts/nda-1`))
})

test('the page is without fault for those who listen to it', { tags: ['slow'] }, async () => {
  await opened()
  await card('Fix')
  await card('Spectrum of the whole sound')
  const { violations } = await axe.run(document.body, {
    rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
  })
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([])
})

test('a version that was renamed before its upload says what it was called', async () => {
  server.on('GET /v1/takes/t1', { ...aVersion(), received_name: 'bounce 7.wav' })
  await opened()
  expect(screen.getByText(/Renamed before the upload from/)).toHaveTextContent('bounce 7.wav')
})

describe('the master', () => {
  const copy = {
    id: 'x1',
    take_id: 't1',
    state: 'making',
    refusal: null,
    fields: { project: 'Shield Wing', originator: 'Sound designer', orderRef: 'SW-009' },
    left: [],
    file_bytes: null,
    file_name: 'airlock_cycle.wav',
    file_url: null,
  }

  test('is had as delivered, or as a copy that says where it comes from', async () => {
    server.on('POST /v1/takes/t1/master-exports', copy)
    server.on('GET /v1/master-exports/x1', {
      ...copy,
      state: 'made',
      file_bytes: 348_000,
      file_url: '/v1/master-exports/x1/file',
      left: ['the "iXML" chunk is empty; it is left as it is'],
    })
    await opened()
    const master = await card('Master')
    expect(within(master).getByRole('link', { name: 'Download as delivered' })).toHaveAttribute(
      'href',
      '/v1/takes/t1/master',
    )
    await userEvent.click(within(master).getByRole('button', { name: 'Create copy with provenance' }))
    const download = await within(master).findByRole('link', { name: 'Download with provenance' })
    expect(download).toHaveAttribute('href', '/v1/master-exports/x1/file')
    expect(download).toHaveAttribute('download', 'airlock_cycle.wav')
    expect(
      within(master)
        .getAllByRole('definition')
        .map((each) => each.textContent),
    ).toEqual(['Shield Wing', 'Sound designer', 'SW-009'])
    expect(master).toHaveTextContent('The "iXML" chunk is empty; it is left as it is.')
  })

  test('that cannot be copied says why', async () => {
    server.on('POST /v1/takes/t1/master-exports', {
      ...copy,
      state: 'refused',
      refusal: 'it ends early; send it again',
    })
    await opened()
    const master = await card('Master')
    await userEvent.click(within(master).getByRole('button', { name: 'Create copy with provenance' }))
    expect(await within(master).findByRole('alert')).toHaveTextContent('It ends early; send it again.')
    expect(within(master).getByRole('link', { name: 'Download as delivered' })).toBeInTheDocument()
  })
})
