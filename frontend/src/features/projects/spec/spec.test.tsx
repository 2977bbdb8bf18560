import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, describe, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import checks from '@/test/checks.json'
import { openApp } from '@/test/openApp'
import { aSpec, inProject, people, TABLES, TOML, tried } from '@/test/project'
import { answer, type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

const SAVE = 'PUT /v1/projects/p1/spec'
const SAVE_FORM = 'POST /v1/projects/p1/spec/form'
const TRY = 'POST /v1/projects/p1/spec/check-toml'

beforeEach(() => vi.stubGlobal('AudioContext', HandContext))

const badSpec = (where: string, message: string) =>
  refusal(422, 'bad-spec', `${where}: ${message}`, { errors: [{ where, message }] })

// Each check is a line of the form: spec.slow.test.tsx draws them all.
const SHOWN = ['naming', 'sample-peak', 'true-peak', 'head-silence', 'noise-floor', 'hum', 'duplicate']
const someChecks = checks.filter(({ name }) => SHOWN.includes(name))

async function openSpec(more: Answers = {}) {
  const server = serve(inProject('producer', { 'GET /v1/checks': someChecks, ...more }))
  const app = openApp('/projects/p1/spec?view=all')
  await screen.findByRole('heading', { name: 'Delivery spec' })
  await screen.findByRole('button', { name: 'TOML' })
  return { ...server, ...app }
}
async function openToml(more: Answers = {}) {
  const server = await openSpec(more)
  await userEvent.click(screen.getByRole('button', { name: 'TOML' }))
  return { ...server, text: screen.getByLabelText<HTMLTextAreaElement>('Spec as TOML') }
}
const type = (field: HTMLElement, value: string) => fireEvent.change(field, { target: { value } })

describe('by form', () => {
  test('shows what the tables say, and what a check does when the spec is silent', { tags: ['slow'] }, async () => {
    await openSpec()
    expect(screen.getByLabelText('True peak, dBTP')).toHaveValue('−1')
    const peak = screen.getByRole('group', { name: 'True peak: result' })
    expect(within(peak).getByRole('button', { name: 'warns' })).toHaveAttribute('aria-pressed', 'true')
    const head = screen.getByRole('group', { name: 'Leading silence: result' })
    expect(within(head).getByRole('button', { name: 'returns' })).toHaveAttribute('aria-pressed', 'true')
    const twice = screen.getByRole('group', { name: 'Duplicate audio: result' })
    expect(
      within(twice)
        .getAllByRole('button')
        .map(({ textContent }) => textContent),
    ).toEqual(['warns', 'off'])
    expect(screen.getByLabelText('Sample peak, dBFS')).toHaveValue('')
    expect(screen.getByRole('button', { name: /Save version 4/ })).toBeDisabled()
    expect(screen.getByText('no changes')).toBeVisible()
  })

  test('a check that the server adds is there with its limit, and needs nothing else', { tags: ['slow'] }, async () => {
    const { asked } = await openSpec({
      'GET /v1/checks': [
        ...someChecks,
        {
          ...checks.find(({ name }) => name === 'noise-floor'),
          name: 'long-crest',
          label: 'Tall peaks',
          severity: 'warning',
          limits: [
            {
              key: 'crest_db',
              label: 'Crest factor',
              unit: 'dB',
              least: 0,
              greatest: 60,
              is_range: false,
              usual: null,
            },
          ],
        },
        { ...checks.find(({ name }) => name === 'hum'), name: 'buzz', label: 'Buzz' },
      ],
    })
    expect(screen.getByRole('group', { name: 'Buzz: result' })).toBeVisible()
    const peaks = screen.getByRole('group', { name: 'Crest factor: result' })
    expect(within(peaks).getByRole('button', { name: 'warns' })).toHaveAttribute('aria-pressed', 'true')
    type(screen.getByLabelText('Crest factor, dB'), '12')
    await screen.findByText('The spec is valid.')
    expect(wrote(asked, TRY).at(-1)?.body).toMatchObject({ tables: { limits: { crest_db: 12 } } })
  })

  test('a change is tried as it is typed, and saved as tables with its note', { tags: ['slow'] }, async () => {
    const { asked, at } = await openSpec({ [SAVE_FORM]: aSpec({ version: 4 }) })
    const field = screen.getByLabelText('True peak, dBTP')
    for (const typed of ['−2', '−2,', '−2,5']) type(field, typed)
    expect(await screen.findByText('The spec is valid.')).toBeVisible()
    // Typing was waited for: what stood there in between was not tried.
    const tries = wrote(asked, TRY).map(({ body }) => (body as { tables: typeof TABLES }).tables.limits.true_peak_dbtp)
    expect(new Set(tries)).toEqual(new Set([TABLES.limits.true_peak_dbtp, -2.5]))
    expect(screen.getByText(/without comments/)).toBeVisible()
    type(screen.getByLabelText(/what changed and why/), 'Less loud')
    await userEvent.click(screen.getByRole('button', { name: /Save version 4/ }))
    await waitFor(() => expect(at()).toBe('/projects/p1'))
    expect(wrote(asked, SAVE_FORM)[0]?.body).toEqual({
      tables: { ...TABLES, limits: { true_peak_dbtp: -2.5, head_silence_ms: 5 } },
      note: 'Less loud',
      based_on_version: 3,
    })
  })

  test('an emptied field takes the limit away', { tags: ['slow'] }, async () => {
    const { asked } = await openSpec()
    await userEvent.clear(screen.getByLabelText('True peak, dBTP'))
    await screen.findByText('The spec is valid.')
    expect(wrote(asked, TRY).at(-1)?.body).toMatchObject({ tables: { limits: { head_silence_ms: 5 } } })
    expect(JSON.stringify(wrote(asked, TRY).map(({ body }) => body))).not.toContain('true_peak_dbtp":"')
  })

  test('what is not a number stays as typed, with the refusal at its field', { tags: ['slow'] }, async () => {
    await openSpec({ [TRY]: badSpec('limits.true_peak_dbtp', 'wanted a number or "any", found "loud"') })
    type(screen.getByLabelText('True peak, dBTP'), 'loud')
    const field = screen.getByLabelText('True peak, dBTP')
    await waitFor(() => expect(field).toHaveAccessibleDescription('Wanted a number or "any", found "loud".'))
    expect(field).toHaveValue('loud')
    await userEvent.click(screen.getByRole('button', { name: 'Go to line' }))
    expect(field).toHaveFocus()
  })

  test('a name is tried against the pattern, and so is the list', { tags: ['slow'] }, async () => {
    await openSpec({
      'GET /v1/projects/p1/sound-list': {
        revision: 1,
        cues: [
          { id: 'a', category: 'impact', state: 'locked', stems: ['shield_hit_01', 'shield_hit_02'] },
          { id: 'b', category: 'ui', state: 'locked', stems: ['UI-Back'] },
        ],
      },
    })
    expect(await screen.findByText('1 of 3 names in the list doesn’t match: UI-Back')).toBeVisible()
    type(screen.getByLabelText('Test a name'), 'Laser')
    expect(screen.getByText('does not match.', { exact: false })).toBeVisible()
    type(screen.getByLabelText('Test a name'), 'laser_2')
    expect(screen.getByText(/laser_2\.wav/).parentElement).toHaveTextContent('laser_2.wav fits.')
  })

  test('targets are added, renamed where categories speak of them, and removed', { tags: ['slow'] }, async () => {
    const { asked } = await openSpec({
      'GET /v1/projects/p1/spec': aSpec({
        tables: { ...TABLES, categories: { music: { targets: { game: { bit_depth: 24 } } } } },
      }),
    })
    const name = within(screen.getByRole('group', { name: /^Target game/ })).getByLabelText('Name')
    type(name, 'console')
    fireEvent.blur(name)
    await userEvent.click(screen.getByRole('button', { name: 'Add target' }))
    await screen.findByText('The spec is valid.')
    await waitFor(() =>
      expect(wrote(asked, TRY).at(-1)?.body).toMatchObject({
        tables: {
          targets: {
            console: { sample_rate_hz: 48000, bit_depth: 16 },
            target: { sample_rate_hz: 48000, bit_depth: 16 },
          },
          categories: { music: { targets: { console: { bit_depth: 24 } } } },
        },
      }),
    )
    await userEvent.click(screen.getByRole('button', { name: 'Remove target' }))
    await waitFor(() => expect(screen.queryByRole('group', { name: /^Target target/ })).toBeNull())
  })

  test('a codec asks for a quality in place of a depth, and Opus for its only rate', { tags: ['slow'] }, async () => {
    const { asked } = await openSpec()
    const target = within(screen.getByRole('group', { name: /^Target game/ }))
    await userEvent.click(target.getByRole('combobox', { name: 'Format' }))
    await userEvent.click(await screen.findByRole('option', { name: 'Opus' }))
    expect(target.queryByRole('combobox', { name: 'Dither' })).toBeNull()
    expect(target.getByRole('combobox', { name: 'Sample rate' })).toHaveValue('48 kHz')
    await userEvent.type(target.getByLabelText('Quality'), '0.3')
    const tried = () => (wrote(asked, TRY).at(-1)?.body as { tables: { targets: Record<string, unknown> } }).tables
    await waitFor(() => expect(tried().targets.game).toMatchObject({ encoding: 'opus', quality: 0.3 }))
    expect(tried().targets.game).not.toHaveProperty('bit_depth')
    expect(screen.getByRole('group', { name: 'Target game: 48 kHz, Opus, quality 0.3, same as master' })).toBeVisible()
    await userEvent.click(target.getByRole('combobox', { name: 'Format' }))
    await userEvent.click(await screen.findByRole('option', { name: '16-bit FLAC' }))
    await waitFor(() => expect(tried().targets.game).toMatchObject({ encoding: 'flac', bit_depth: 16 }))
    expect(tried().targets.game).not.toHaveProperty('quality')
    expect(target.getByRole('combobox', { name: 'Dither' })).toBeVisible()
  })

  test('a category is added from the list and says only what differs', { tags: ['slow'] }, async () => {
    const { asked } = await openSpec()
    await userEvent.click(await screen.findByRole('button', { name: 'impact' }))
    await userEvent.click(screen.getByText('impact', { selector: 'summary span' }))
    const own = within(screen.getByText('impact', { selector: 'summary span' }).closest('details') ?? document.body)
    expect(own.getByLabelText('True peak, dBTP')).toHaveAttribute('placeholder', 'general rule: −1')
    await userEvent.type(own.getByLabelText('True peak, dBTP'), '-3')
    await waitFor(() =>
      expect(wrote(asked, TRY).at(-1)?.body).toMatchObject({
        tables: { categories: { ...TABLES.categories, impact: { limits: { true_peak_dbtp: -3 } } } },
      }),
    )
  })

  test('axe finds nothing', { tags: ['slow'] }, async () => {
    await openSpec()
    const { violations } = await axe.run(document.body, {
      rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
    })
    expect(violations.map(({ id }) => id)).toEqual([])
  })
})

describe('as TOML', () => {
  const WRONG = TOML.replace('true_peak_dbtp', 'true_peak')
  const MESSAGE = 'unknown key; the nearest known is "true_peak_dbtp"'
  const tryToml = ({ body }: Asked) => {
    const { toml } = body as { toml: string }
    return toml.includes('true_peak ') ? badSpec('limits.true_peak', MESSAGE) : tried(toml)
  }

  test('an unknown key is reported at its line, and corrected by one press', { tags: ['slow'] }, async () => {
    const { text } = await openToml({ [TRY]: tryToml })
    type(text, WRONG)
    expect(await screen.findByText('limits.true_peak')).toBeVisible()
    expect(screen.getByRole('button', { name: 'Line 5' })).toBeVisible()
    expect(text).toHaveAttribute('aria-invalid', 'true')
    await userEvent.click(screen.getByRole('button', { name: 'Use true_peak_dbtp' }))
    expect(text).toHaveValue(TOML)
    expect(screen.getByText('no changes')).toBeVisible()
  })

  test('what is not a spec cannot be shown as a form, and says so', { tags: ['slow'] }, async () => {
    const { text } = await openToml({ [TRY]: tryToml })
    type(text, WRONG)
    await screen.findByText('limits.true_peak')
    await userEvent.click(screen.getByRole('button', { name: 'Form' }))
    expect(screen.getByText('Fix the error to switch to form.')).toBeVisible()
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(WRONG)
  })

  test('warnings are shown, and the text is saved to the letter', { tags: ['slow'] }, async () => {
    const next = TOML.replace('-1.0 ', '-2.0 ')
    const { asked, text, at } = await openToml({
      [TRY]: tried(next, TABLES, ['two targets make unchanged file']),
      [SAVE]: aSpec({ version: 4, toml: next }),
    })
    type(text, next)
    expect(await screen.findByText('Two targets make unchanged file.')).toBeVisible()
    await userEvent.keyboard('{Control>}s{/Control}')
    await waitFor(() => expect(at()).toBe('/projects/p1'))
    expect(wrote(asked, SAVE)[0]?.body).toEqual({ toml: next, note: '', based_on_version: 3 })
  })

  test('comments survive a look at the form', { tags: ['slow'] }, async () => {
    const { text } = await openToml()
    const next = TOML.replace('# a warning', '# said twice')
    type(text, next)
    await screen.findByText('The spec is valid.')
    await userEvent.click(screen.getByRole('button', { name: 'Form' }))
    await userEvent.click(screen.getByRole('button', { name: 'TOML' }))
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(next)
  })

  test('a saved version is taken back by Undo, as one version more', async () => {
    const next = TOML.replace('= 5', '= 6')
    const { asked, text, at } = await openToml({
      [SAVE]: ({ body }: Asked) => aSpec({ version: (body as { based_on_version: number }).based_on_version + 1 }),
    })
    type(text, next)
    await screen.findByText('The spec is valid.')
    await userEvent.click(screen.getByRole('button', { name: /Save version 4/ }))
    await waitFor(() => expect(at()).toBe('/projects/p1'))
    await userEvent.click(await screen.findByRole('button', { name: /Undo/ }))
    await waitFor(() => expect(wrote(asked, SAVE)).toHaveLength(2))
    expect(wrote(asked, SAVE)[1]?.body).toEqual({ toml: TOML, note: 'As version 3', based_on_version: 4 })
  })

  test('what was typed and not saved is there again', { tags: ['slow'] }, async () => {
    const { text } = await openToml()
    type(text, `${TOML}# later\n`)
    await screen.findByText('The spec is valid.')
    document.body.innerHTML = ''
    serve(inProject('producer', { 'GET /v1/checks': someChecks }))
    openApp('/projects/p1/spec?view=all')
    expect(await screen.findByText('Your unsaved changes were restored.')).toBeVisible()
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(`${TOML}# later\n`)
    await userEvent.click(screen.getByRole('button', { name: 'Discard' }))
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(TOML)
  })
})

describe('when another person saved', () => {
  const THEIRS = TOML.replace('head_silence_ms = 5', 'head_silence_ms = 8')
  const MINE = TOML.replace('-1.0 ', '-2.0 ')
  const moved = refusal(409, 'spec-changed', 'Audio director saved version 4; yours began from version 3')

  async function conflict() {
    const server = await openToml({
      [SAVE]: ({ body }: Asked) =>
        (body as { based_on_version: number }).based_on_version === 3 ? moved : aSpec({ version: 5, toml: MINE }),
    })
    type(server.text, MINE)
    await screen.findByText('The spec is valid.')
    server.answers['GET /v1/projects/p1/spec'] = aSpec({
      version: 4,
      toml: THEIRS,
      note: 'Eight at the head',
      author: people.approver,
    })
    await userEvent.click(screen.getByRole('button', { name: /Save version 4/ }))
    await screen.findByRole('heading', { name: 'Audio director saved version 4 while you were editing' })
    return server
  }

  test('both texts stand, line against line, and nothing typed is lost', async () => {
    await conflict()
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(MINE)
    const diff = screen.getByRole('region', { name: 'Version 4 compared with yours' })
    expect(within(diff).getByText('head_silence_ms = 8')).toBeVisible()
    expect(within(diff).getByText('head_silence_ms = 5')).toBeVisible()
    expect(screen.getByText('Their note: Eight at the head.')).toBeVisible()
    expect(screen.getByRole('button', { name: /Save version 5/ })).toBeDisabled()
  })

  test('mine goes on over theirs', { tags: ['slow'] }, async () => {
    const { asked, at } = await conflict()
    await userEvent.click(screen.getByRole('button', { name: 'Keep mine and replace version 4' }))
    await userEvent.click(screen.getByRole('button', { name: /Save version 5/ }))
    await waitFor(() => expect(at()).toBe('/projects/p1'))
    expect(wrote(asked, SAVE).at(-1)?.body).toEqual({ toml: MINE, note: '', based_on_version: 4 })
  })

  test('theirs is taken, and mine comes back by Undo', { tags: ['slow'] }, async () => {
    await conflict()
    await userEvent.click(screen.getByRole('button', { name: 'Use version 4 and discard mine' }))
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(THEIRS)
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    expect(screen.getByLabelText('Spec as TOML')).toHaveValue(MINE)
  })
})

describe('versions', () => {
  const OLD = TOML.replace('= 5', '= 9')
  const brief = (version: number, note: string) => ({
    version,
    sha256: '',
    note,
    created_at: '2026-11-09T10:00:00Z',
    author: people.producer,
  })
  const versions: Answers = {
    'GET /v1/projects/p1/spec/versions': {
      items: [brief(3, 'Handheld dropped'), brief(2, 'Shorter heads')],
      next: null,
    },
    'GET /v1/projects/p1/spec/versions/3': aSpec(),
    'GET /v1/projects/p1/spec/versions/2': aSpec({ version: 2, toml: OLD, note: 'Shorter heads' }),
    'GET /v1/projects/p1/spec/versions/1': aSpec({ version: 1, toml: 'format = 1\n' }),
  }

  test('a version is compared with the one before, to the letter, and read whole', async () => {
    serve(inProject('producer', versions))
    openApp('/projects/p1/spec/versions')
    await userEvent.click(await screen.findByRole('button', { name: 'Line by line' }))
    const diff = await screen.findByRole('region', { name: 'Version 2 compared with 3' })
    expect(within(diff).getByText('head_silence_ms = 9')).toHaveTextContent('removed: head_silence_ms = 9')
    expect(within(diff).getByText('head_silence_ms = 5')).toHaveTextContent('added: head_silence_ms = 5')
    await userEvent.click(screen.getByRole('button', { name: 'Text' }))
    expect(screen.getByRole('region', { name: 'Text of version 3' })).toHaveTextContent('name = "Shield Wing"')
  })

  test('an old version is taken up again as a draft on the newest', async () => {
    const { asked } = serve(inProject('producer', { ...versions, [SAVE]: aSpec({ version: 4, toml: OLD }) }))
    const { at } = openApp('/projects/p1/spec/versions?version=2')
    await userEvent.click(await screen.findByRole('button', { name: 'Restore this version' }))
    await waitFor(() => expect(at()).toBe('/projects/p1/spec'))
    expect(await screen.findByLabelText('Spec as TOML')).toHaveValue(OLD)
    await userEvent.click(screen.getByRole('button', { name: /Save version 4/ }))
    await waitFor(() =>
      expect(wrote(asked, SAVE)[0]?.body).toEqual({ toml: OLD, note: 'As version 2', based_on_version: 3 }),
    )
  })
})

test('a reviewer changes nothing, and sees who does', async () => {
  serve(inProject('reviewer'))
  openApp('/projects/p1/spec?view=all')
  expect(await screen.findByRole('heading', { name: 'Only producers and audio leads can edit the spec' })).toBeVisible()
  expect(screen.queryByRole('button', { name: /Save/ })).toBeNull()
})

test('another refusal of saving is said where it happened, and the text stays', { tags: ['slow'] }, async () => {
  const { text } = await openToml({
    [SAVE]: answer({ title: 'Gone', code: 'team-needed', detail: 'only a producer or a liaison can do this' }, 403),
  })
  type(text, `${TOML}# more\n`)
  await screen.findByText('The spec is valid.')
  await userEvent.click(screen.getByRole('button', { name: /Save version 4/ }))
  expect(await screen.findByRole('alert')).toHaveTextContent('Only a producer or a liaison can do this.')
  expect(text).toHaveValue(`${TOML}# more\n`)
})
