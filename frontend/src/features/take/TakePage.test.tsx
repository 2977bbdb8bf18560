import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aFinding, aMe, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'
import { aCheck, aGameFile, aFix, aTakeServer, aVersion, DESIGNER, LATE, someSounds } from '@/test/take'

beforeAll(() => import('./TakePage'))

let server: ReturnType<typeof aTakeServer>
let contexts: HandContext[]

beforeEach(() => {
  dismissToast()
  contexts = []
  vi.stubGlobal(
    'AudioContext',
    class extends HandContext {
      constructor() {
        super()
        contexts.push(this)
      }
    },
  )
  server = aTakeServer()
})

const opened = async () => {
  const app = openApp('/takes/t1')
  await screen.findByRole('heading', { level: 1, name: 'airlock_cycle' })
  return app
}
const card = (name: string) => screen.findByRole('region', { name })
const lastStarted = () => contexts.at(-1)?.started.at(-1)

describe('the judgement of reverb', () => {
  const decay = {
    start_s: 0.8,
    step_s: 0.05,
    bands: [
      { hz: 500, rt60_s: 1.82, rate_db_s: -33, curve_db: [0, -2, -20, -45] },
      { hz: 4000, rt60_s: null, rate_db_s: null, curve_db: [0, -9] },
    ],
  }
  const judged = (coherence: unknown) =>
    aCheck({
      judgements: { reverb: { verdict: 'reverb', score: 0.99, rt60_s: 1.8, evidence: { decay, coherence } } },
    })

  test('shows what it goes by, octave for octave', async () => {
    server.on('GET /v1/takes/t1/check', judged([{ hz: 500, head: 0.97, tail: 0.31 }]))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('reverb, about 1.8 s, score 0.99')
    expect(within(shown).getByRole('img')).toHaveAccessibleName(/2 octaves over 0.15 s/)
    const rows = within(within(shown).getByRole('table')).getAllByRole('row')
    expect(rows.map((row) => row.textContent)).toEqual([
      'OctaveRT60RateL/R correlation, start to tail',
      '500 Hz1.82 s−33 dB/s0.97 to 0.31',
      '4 kHztoo short to measureno tail to compare',
    ])
  })

  test('says nothing of left and right in mono', async () => {
    server.on('GET /v1/takes/t1/check', judged(null))
    await opened()
    expect(await card('Reverb?')).not.toHaveTextContent('Left')
  })

  test('draws nothing where nothing could be judged', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { verdict: 'undecided', score: null } } }))
    await opened()
    await card('Measurements')
    expect(screen.queryByRole('region', { name: 'Reverb?' })).toBeNull()
  })
})

describe('reverb beside the version before', () => {
  const band = { hz: 500, curve_db: [0, -20, -40], rt60_s: 1.82, rate_db_s: -33 }
  const evidence = { decay: { start_s: 0, step_s: 0.05, bands: [band] }, coherence: null }
  const reverb = { verdict: 'reverb', score: 0.99, rt60_s: 1.8, evidence }
  const bands = [
    { hz: 500, rt60_s: 1.82, earlier_rt60_s: 0.2 },
    { hz: 1000, rt60_s: 0.22, earlier_rt60_s: 0.21 },
  ]
  const before = { take_id: 't0', number: 1, verdict: 'more reverb', rt60_s: 1.75, wet_db: -6.2, evidence: { bands } }

  test('says which has more, by how much, and where tails are slower', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { ...reverb, before } } }))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('Compared with version 1: more reverb.')
    expect(shown).toHaveTextContent('is 6.2 dB under the sound and falls by 60 dB in 1.75 s')
    expect(within(shown).getByRole('link', { name: 'Compared with version 1' })).toHaveAttribute('href', '/takes/t0')
    const tails = within(within(shown).getByRole('list', { name: 'Tails compared with version 1' })).getAllByRole(
      'listitem',
    )
    expect(tails.map((tail) => tail.textContent)).toEqual(['500 Hz: 1.62 s slower'])
  })

  test('says that another sound cannot be compared', async () => {
    const other = { ...before, verdict: 'undecided', rt60_s: null, wet_db: null }
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { ...reverb, before: other } } }))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('Compared with version 1: not the same sound')
    expect(within(shown).queryByRole('list')).toBeNull()
  })
})

test('the judgement of direction shows how each octave rises and falls', async () => {
  const bands = [
    { hz: 500, rise_db_s: 1200, fall_db_s: 80 },
    { hz: 4000, rise_db_s: 900, fall_db_s: 240 },
  ]
  server.on(
    'GET /v1/takes/t1/check',
    aCheck({ judgements: { reversed: { verdict: 'forwards', score: 0.03, evidence: { bands } } } }),
  )
  await opened()
  const shown = await card('Reversed?')
  expect(shown).toHaveTextContent('forwards, score 0.03')
  const rows = within(within(shown).getByRole('table')).getAllByRole('row')
  expect(rows.map((row) => row.textContent)).toEqual([
    'OctaveRisesFalls',
    '500 Hz1,200 dB/s80 dB/s',
    '4 kHz900 dB/s240 dB/s',
  ])
})

test('the judgement of a lower rate shows the spectrum, and asks', async () => {
  const spectrum = { step_hz: 6_000, dbfs: [-40, -60, -130, -131] }
  const judged = { verdict: 'upsampled', score: 0.99, from_hz: 24_000, edge_hz: 11_900, drop_db: 71.5 }
  server.on('GET /v1/takes/t1/check', aCheck({ judgements: { upsampled: { ...judged, evidence: { spectrum } } } }))
  await opened()
  const shown = await card('Upsampled?')
  expect(shown).toHaveTextContent('upsampled, score 0.99')
  expect(shown).toHaveTextContent('That matches resampling from 24 kHz.')
  expect(within(shown).getByRole('img')).toHaveAccessibleName(
    'Mean spectrum from 0 Hz to 24.0 kHz. Its spectrum ends at 11.9 kHz, dropping by 71.5 dB.',
  )
  expect(shown.querySelector('polyline')?.getAttribute('points')?.split(' ')).toHaveLength(4)
})

describe('the judgement of lossy coding', () => {
  const spectrum = { step_hz: 6_000, dbfs: [-40, -60, -130, -131] }
  const frames = { codec: 'MP3', rate_hz: 44_100, frame: 576, shares: [0.03, 0.04, 0.42, 0.03] }
  const judged = { verdict: 'lossy', score: 0.99, codec: 'MP3', coded_at_hz: 44_100, silent_share: 0.42 }

  test('shows the place where the codec’s frames stand and where the spectrum ends, and asks', async () => {
    const figures = { ...judged, elsewhere_share: 0.04, low_pass_hz: 16_100 }
    server.on(
      'GET /v1/takes/t1/check',
      aCheck({ judgements: { lossy: { ...figures, evidence: { spectrum, frames } } } }),
    )
    await opened()
    const shown = await card('Was it converted from a lossy file?')
    expect(shown).toHaveTextContent('lossy, score 0.99')
    expect(shown).toHaveTextContent('One position stands out, 42 % against 4 % elsewhere')
    expect(within(shown).getByRole('img', { name: /lines of MP3 at 576 places, at most 42 %/ })).toBeInTheDocument()
    expect(within(shown).getByRole('img', { name: /It ends steeply at 16.1 kHz/ })).toBeInTheDocument()
    expect(shown.querySelectorAll('[data-most]')).toHaveLength(1)
  })

  test('of a clean sound shows that no place stands out', async () => {
    const clean = { verdict: 'clean', score: 0.02, codec: null, low_pass_hz: null, elsewhere_share: null }
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { lossy: { ...clean, evidence: { spectrum, frames } } } }))
    await opened()
    const shown = await card('Was it converted from a lossy file?')
    expect(shown).toHaveTextContent('No position stands out')
    expect(within(shown).getAllByRole('img')).toHaveLength(1)
  })
})

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

describe('the fix', () => {
  test('is seen before and after, with what changes, and used by its designer in one press', async () => {
    const user = userEvent.setup()
    server.on('POST /v1/takes/t1/fix/use', aVersion({ id: 't2', number: 2, state: 'received', fix_of_id: 't1' }))
    await opened()
    const fix = await card('Fix')
    expect(await within(fix).findByRole('slider', { name: 'Position in airlock_cycle, fixed' })).toBeInTheDocument()
    const changes = within(fix).getByLabelText('What changes')
    expect(changes).toHaveTextContent('Sample peak0.0 dBFS →becomes −1.6 dBFS')
    expect(changes).toHaveTextContent('Length0.80 s →becomes 0.40 s')
    expect(fix).toHaveTextContent('It becomes version 2; version 1 is kept. No round is counted.')
    await user.click(within(fix).getByRole('button', { name: 'Start' }))
    expect(within(fix).getByText('The start, 0.000–0.500 s')).toBeInTheDocument()
    await user.keyboard('t')
    expect(
      await screen.findByText('airlock_cycle version 2 is the fixed copy. It is being checked.'),
    ).toBeInTheDocument()
    expect(server.of('POST /v1/takes/t1/fix/use')).toHaveLength(1)
  })

  test('b hears the other one at the same place in the sound', async () => {
    const user = userEvent.setup()
    await opened()
    const fix = await card('Fix')
    await within(fix).findByRole('button', { name: /^Play fixed/ })
    await user.click(await screen.findByRole('button', { name: /^Play(?! (original|fixed))/ }))
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.8))
    const context = contexts.at(-1)
    if (context) context.currentTime = 0.6
    await user.keyboard('b')
    // 0.4 s were cut from the start: 0.6 s of the one are 0.2 s of the other.
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.4))
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.2))
    await user.keyboard('b')
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.8))
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.6))
  })

  test('is made when its designer asks, and shown once it is made', async () => {
    const user = userEvent.setup()
    let state: 'offered' | 'making' | 'made' = 'offered'
    server
      .on('GET /v1/takes/t1/fix', () => aFix({ state, says: 'Trims 407.0 ms from the start.' }))
      .on('POST /v1/takes/t1/fix', () => {
        state = 'making'
        return aFix({ state })
      })
    await opened()
    const fix = await card('Fix')
    expect(fix).toHaveTextContent('Auto-fix: trims 407.0 ms from the start.')
    await user.click(within(fix).getByRole('button', { name: /^Make auto-fix/ }))
    expect(await within(fix).findByText(/Making the fixed copy/)).toBeInTheDocument()
    state = 'made'
    expect(await within(fix).findByRole('button', { name: /^Use auto-fix/ })).toBeInTheDocument()
  })

  test('the approver sees that it is offered, and cannot use it', async () => {
    server.on('GET /v1/me', aMe())
    const user = userEvent.setup()
    await opened()
    const fix = await card('Fix')
    expect(fix).toHaveTextContent('The designer decides whether to use it.')
    expect(within(fix).queryByRole('button', { name: /^Use auto-fix/ })).not.toBeInTheDocument()
    await user.keyboard('t')
    expect(server.asked.some(({ method }) => method === 'POST')).toBe(false)
  })

  test('a refusal stays where it happened', async () => {
    const user = userEvent.setup()
    server.on(
      'POST /v1/takes/t1/fix/use',
      refusal(409, 'nothing-to-fix', 'a change_requested version is decided upon', { fix: 'send your own version' }),
    )
    await opened()
    await user.click(await screen.findByRole('button', { name: /^Use auto-fix/ }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'A change_requested version is decided upon. Send your own version.',
    )
  })

  test('our own fault can be tried again', async () => {
    server.on('GET /v1/takes/t1/fix', aFix({ state: 'refused', says: 'Our mender failed.', is_our_fault: true }))
    await opened()
    expect(await screen.findByRole('button', { name: /^Make auto-fix/ })).toBeInTheDocument()
    expect(screen.getByText('Our mender failed.')).toBeInTheDocument()
  })

  test('both versions lead to each other, with who agreed', async () => {
    server.on('GET /v1/takes/t1/fix', aFix({ state: 'used', new_take_id: 't2', used_by: DESIGNER }))
    await opened()
    const link = await screen.findByRole('link', { name: 'Version 2' })
    expect(link).toHaveAttribute('href', '/takes/t2')
    expect(link.parentElement).toHaveTextContent('Version 2 is its fix, with the consent of Sound designer.')
  })

  test('a fix says what it was made of', async () => {
    const { repairs } = aFix()
    server.on(
      'GET /v1/takes/t1/fix',
      aFix({
        state: 'none',
        fixed_from: { take_id: 't0', number: 1, repairs, used_by: DESIGNER, used_at: '2026-11-20T10:00:00Z' },
      }),
    )
    await opened()
    expect(await screen.findByRole('link', { name: 'version 1' })).toHaveAttribute('href', '/takes/t0')
    expect(screen.getByText(/level lowered by 1\.62 dB\.$/)).toBeInTheDocument()
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
    await waitFor(() => expect(master).toHaveTextContent('Opens by payment'))
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

test('the page is without fault for those who listen to it', async () => {
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
