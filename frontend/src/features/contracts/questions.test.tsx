import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { CONTRACT, contractAnswers, marked, MAY, PAGE, VERSION } from '@/test/contract'
import { openApp } from '@/test/openApp'
import { type Answers, type Asked, refusal, serve, wrote } from '@/test/server'

import type { Draft, LibraryClause } from './api'
import { valueOf } from './FigureField'
import { onePayment, type Part, shareBp, totalOf, withShare } from './planParts'
import { isChanged, questionOf, saysRights, saysRounds } from './questions'

const KEYS = [
  'parties',
  'services',
  'rounds',
  'rates',
  'payment_plan',
  'ownership',
  'reel',
  'tax',
  'disputes',
  'silence',
]
const TEXTS: Record<string, string> = {
  rounds: 'It includes {rounds_included} rounds.',
  rates: 'A further round costs {extra_round_bp}.',
  payment_plan: 'The price is {total}.',
}
const TERMS = { rounds_included: 2, extra_round_bp: 2500, silence_days: 10 }
const clauses = KEYS.map((key) => ({
  key,
  title: `Clause ${key}`,
  text: TEXTS[key] ?? `Words of ${key}.`,
  stands: key !== 'silence',
}))
const draft = {
  ...CONTRACT,
  state: 'draft',
  my_party: 'studio',
  currency: 'EUR',
  may: { ...MAY, change: true, send: true },
  version: { ...VERSION, number: 1, clauses, terms: TERMS },
}
const term = (name: string, label: string) => ({ name, label, default: 0, min: 0, max: 20, choices: [] })
const library = clauses.map(({ key, title, text, stands }) => ({
  ...{ key, title, text, stands, why: `Why ${key}.`, music: false, instead_of: null },
  terms:
    key === 'rounds'
      ? [term('rounds_included', 'Rounds included')]
      : key === 'rates'
        ? [term('extra_round_bp', 'A further round')]
        : key === 'silence'
          ? [term('silence_days', 'Days of silence')]
          : [],
}))

/** The preview as the server answers it: the clauses that stand, figures marked. */
function preview({ body }: Asked, total: string) {
  const { clauses: typed, terms } = body as Draft
  const standing = typed.filter(({ stands }) => stands)
  const words = (key: string) =>
    key === 'rounds'
      ? marked('It includes ', ['rounds_included', String(terms.rounds_included)], ' rounds.')
      : key === 'rates'
        ? marked('A further round costs ', ['extra_round_bp', `${Number(terms.extra_round_bp) / 100} %`], '.')
        : key === 'payment_plan'
          ? marked('The price is ', ['total', total], '.')
          : marked(`Words of ${key}.`)
  return {
    blocks: standing.map(({ key }) => words(key)),
    clauses: standing.map(({ key, title }, at) => ({ key, title, number: at + 1, first_block: at, block_count: 1 })),
    problems: [],
  }
}

const price = (total: number) => ({
  ...{ total_minor: total, deposit_minor: total / 5, bid_minor: 100_000, bid_currency: 'EUR' },
  above_bid_minor: total - 100_000,
})
const NO_CONCEPTS = { count: 0, cues: 2, amount_minor: 0 }
const NO_PLAN = {
  ...{ contract_id: 'c1', state: 'draft', currency: 'EUR', milestones: [], advice: [], concepts: NO_CONCEPTS },
  price: { ...price(0), deposit_minor: 0, above_bid_minor: null, bid_minor: null, bid_currency: null },
}
const proposed = (total: number) => ({
  milestones: [
    { name: 'Deposit', due_on: null, cue_ids: [], amount_minor: total * 0.2, is_deposit: true },
    { name: 'Alpha', due_on: '2027-01-08', cue_ids: ['a'], amount_minor: total * 0.4, is_deposit: false },
    { name: 'Beta', due_on: '2027-02-08', cue_ids: ['b'], amount_minor: total * 0.4, is_deposit: false },
  ],
})
const cue = (id: string) => ({ id, name: id, number: 1, category: 'ui', state: 'locked', variations: 2, stems: [] })

function openDraft(more: Answers = {}) {
  let saved: unknown = NO_PLAN
  const server = serve(
    contractAnswers({
      'GET /v1/contracts/c1': draft,
      'POST /v1/contracts/c1/preview': (asked: Asked) =>
        preview(asked, saved === NO_PLAN ? 'EUR 0.00' : 'EUR 1,000.00'),
      'GET /v1/contract-library/single': { kind: 'single', notice: '', clauses: library, variables: {} },
      'GET /v1/projects/p1/sound-list': { revision: 1, cues: [cue('a'), cue('b')], next: null },
      'GET /v1/projects/p1/effort': { cues: 0 },
      'GET /v1/contracts/c1/milestones': () => saved,
      'GET /v1/contracts/c1/milestones/proposal': ({ query }: Asked) => proposed(Number(query?.get('total_minor'))),
      'POST /v1/contracts/c1/plan-check': { faults: [], advice: [], price: price(100_000), concepts: NO_CONCEPTS },
      'PUT /v1/contracts/c1/milestones': ({ body }: Asked) => {
        const { milestones } = body as { milestones: Part[] }
        saved = {
          ...NO_PLAN,
          price: price(100_000),
          milestones: milestones.map((part, at) => ({
            ...{ ...part, id: `m${at}`, position: at + 1, tax_bp: null },
            cues: part.cues.map(({ cue_id }) => ({ cue: { id: cue_id }, price_minor: null, estimate_min: null })),
          })),
        }
        return saved
      },
      'POST /v1/contracts/c1/send': { ...draft, state: 'sent' },
      ...more,
    }),
  )
  return { ...server, ...openApp(`${PAGE}/draft`) }
}

const PRICE = 'Price, deposit included'
const send = () => screen.getByRole('button', { name: /^Send to/ })

describe('the five questions of a draft', () => {
  test('a price gets a plan, one press uses it, and it can be sent', { tags: ['slow'] }, async () => {
    const { asked, at } = openDraft()
    const field = await screen.findByLabelText(PRICE)
    expect(send()).toHaveAttribute('aria-disabled', 'true')
    await userEvent.type(field, '1000{Enter}')
    await waitFor(() => expect(wrote(asked, 'PUT /v1/contracts/c1/milestones')).toHaveLength(1))
    const { milestones } = wrote(asked, 'PUT /v1/contracts/c1/milestones')[0]?.body as { milestones: Part[] }
    expect(milestones.map(({ name, amount_minor }) => [name, amount_minor])).toEqual([
      ['Deposit', 20_000],
      ['Alpha', 40_000],
      ['Beta', 40_000],
    ])
    expect(milestones[1]?.cues).toEqual([{ cue_id: 'a', price_minor: null, estimate_min: null }])
    expect(await screen.findByText('€1,000.00 in 3 parts; 20 % at signing')).toBeVisible()
    expect(screen.getByText(/the same as the bid/)).toBeVisible()
    expect(await screen.findByRole('button', { name: 'EUR 1,000.00' })).toBeVisible()
    await userEvent.click(send())
    await waitFor(() => expect(at()).toBe(PAGE))
    expect(wrote(asked, 'POST /v1/contracts/c1/send')).toHaveLength(1)
    expect(wrote(asked, 'PUT /v1/contracts/c1/draft')).toHaveLength(0)
  })

  test('is not sent with a question open, which is named and opened', async () => {
    const { asked } = openDraft()
    await screen.findByLabelText(PRICE)
    await userEvent.keyboard('{Escape}')
    await userEvent.click(screen.getByRole('button', { name: /Rights/ }))
    await userEvent.click(send())
    expect(screen.getByRole('alert')).toHaveTextContent('Not sent: price and schedule is open. Enter a price.')
    expect(screen.getByLabelText(PRICE)).toBeVisible()
    expect(wrote(asked, 'POST /v1/contracts/c1/send')).toHaveLength(0)
  })

  test(
    'a figure typed over in the text is the one of its question, saved and sent as one value',
    { tags: ['slow'] },
    async () => {
      const version = { ...VERSION, number: 2 }
      const { asked } = openDraft({
        'PUT /v1/contracts/c1/draft': ({ body }: Asked) => ({ ...draft, version: { ...version, ...(body as Draft) } }),
      })
      const text = within(await screen.findByRole('region', { name: 'The text' }))
      const field = await text.findByRole('textbox', { name: 'Rounds included' })
      await userEvent.clear(field)
      await userEvent.type(field, '4')
      await userEvent.click(screen.getByRole('button', { name: /Rounds of changes/ }))
      expect(await screen.findByText('A further round costs', { exact: false })).toBeVisible()
      const answers = within(screen.getByRole('list', { name: 'Questions' }))
      expect(answers.getByLabelText('Rounds included')).toHaveValue('4')
      await userEvent.type(screen.getByRole('button', { name: /Price and schedule/ }), '{Enter}')
      expect(answers.getByText(/^4 rounds included; a further one costs 25 %/)).toBeVisible()
      await userEvent.keyboard('{Control>}s{/Control}')
      await waitFor(() => expect(wrote(asked, 'PUT /v1/contracts/c1/draft')).toHaveLength(1))
      expect(wrote(asked, 'PUT /v1/contracts/c1/draft')[0]?.body).toMatchObject({
        terms: { ...TERMS, rounds_included: 4 },
        based_on_version: 1,
      })
    },
  )

  test(
    'usual clauses are folded, a changed one stands open, and there are at most 40 controls',
    { tags: ['slow'] },
    async () => {
      openDraft({
        'GET /v1/contracts/c1': {
          ...draft,
          version: {
            ...draft.version,
            number: 2,
            clauses: clauses.map((clause) => (clause.key === 'tax' ? { ...clause, text: 'Our own.' } : clause)),
          },
        },
        'GET /v1/contracts/c1/versions/1': draft.version,
      })
      const text = within(await screen.findByRole('region', { name: 'The text' }))
      expect(await text.findByRole('button', { name: /^1 usual clause/ })).toHaveAttribute('aria-expanded', 'false')
      expect(text.getByRole('region', { name: 'Clause tax' })).toBeVisible()
      expect(text.queryByRole('region', { name: 'Clause disputes' })).not.toBeInTheDocument()
      await screen.findByLabelText(PRICE)
      const main = document.querySelector('main') as HTMLElement
      expect(main.querySelectorAll('button, a, input, select, textarea').length).toBeLessThanOrEqual(40)
      await userEvent.click(text.getByRole('button', { name: /usual clause/ }))
      expect(text.getByRole('region', { name: 'Clause disputes' })).toBeVisible()
      await userEvent.click(text.getByRole('button', { name: /^Add a clause/ }))
      await userEvent.click(text.getByRole('button', { name: 'Add Clause silence' }))
      expect(await text.findByRole('region', { name: 'Clause silence' })).toBeVisible()
    },
  )

  test(
    'a warning stands under the part that causes it, and the keys 1 to 5 open the questions',
    { tags: ['slow'] },
    async () => {
      const advice = [{ code: 'not-rising', message: 'Beta pays less.', why: 'Why.', subject: 'Beta' }]
      openDraft({
        'POST /v1/contracts/c1/plan-check': { faults: [], advice, price: price(120_000), concepts: NO_CONCEPTS },
      })
      await userEvent.type(await screen.findByLabelText(PRICE), '1200')
      const row = within(await screen.findByRole('row', { name: /Beta/ }))
      expect(await row.findByText('Beta pays less.')).toBeVisible()
      expect(screen.getByText('€200.00 more than the bid of €1,000.00')).toBeVisible()
      await userEvent.click(screen.getByRole('heading', { level: 1 }))
      await userEvent.keyboard('5')
      expect(screen.getByRole('radio', { name: 'when it is paid' })).toBeChecked()
      await userEvent.click(screen.getByRole('heading', { level: 1 }))
      await userEvent.keyboard('1')
      expect(screen.getByLabelText('Title of the contract')).toHaveValue('Effects for Alpha')
    },
  )

  test('what the server refuses to send is said above the button', { tags: ['slow'] }, async () => {
    openDraft({ 'POST /v1/contracts/c1/send': refusal(409, 'brief-open', 'a needed answer of the brief is open') })
    await userEvent.type(await screen.findByLabelText(PRICE), '1000{Enter}')
    await screen.findByText('€1,000.00 in 3 parts; 20 % at signing')
    await userEvent.keyboard('{Control>}{Enter}{/Control}')
    expect(await screen.findByText(/needed answer of the brief is open/)).toBeVisible()
  })
})

describe('rules', () => {
  const value = { ...draft, clauses, terms: TERMS } as unknown as Draft
  const known = library as unknown as LibraryClause[]

  test('a fault belongs to the question whose clause or value it names', () => {
    const at = (where: string) => questionOf({ where, message: '' }, value, known)
    expect(at('clauses.payment_plan')).toBe('price')
    expect(at('terms.rounds_included')).toBe('rounds')
    expect(at('clauses.tax')).toBeNull()
    expect(at('clauses')).toBeNull()
  })

  test('a clause is changed by its words, and by a value of it', () => {
    const rounds = clauses.find(({ key }) => key === 'rounds')
    if (!rounds) throw new Error('no rounds')
    const begun = { clauses, terms: TERMS }
    const library = known.find(({ key }) => key === 'rounds')
    expect(isChanged(rounds, begun, value, library)).toBe(false)
    expect(isChanged({ ...rounds, text: 'Other.' }, begun, value, library)).toBe(true)
    expect(isChanged(rounds, begun, { ...value, terms: { ...TERMS, rounds_included: 3 } }, library)).toBe(true)
  })

  test('answers say what the clauses do', () => {
    expect(saysRounds(value)).toBe('2 rounds included; a further one costs 25 %. No acceptance by silence.')
    const silent = { ...value, clauses: clauses.map((clause) => ({ ...clause, stands: true })) }
    expect(saysRounds(silent)).toMatch(/Silence of 10 working days accepts\.$/)
    expect(saysRights(value, 'Teo')).toBe('All rights pass with payment; Teo may show the work.')
  })

  test('shares and amounts are one value, and one payment is the whole price', () => {
    const parts: Part[] = ['A', 'B'].map((name, at) => ({
      ...{ name, due_on: `2027-0${at + 1}-01`, is_deposit: false, amount_minor: 500, tax_bp: null },
      cues: [{ cue_id: name, price_minor: 500, estimate_min: null }],
    }))
    const shifted = withShare(parts, 0, 3333, 1000)
    expect(shifted.map(({ amount_minor }) => amount_minor)).toEqual([333, 500])
    expect(shareBp(shifted[0] as Part, 1000)).toBe(3330)
    expect(shifted[0]?.cues[0]?.price_minor).toBeNull()
    const [whole] = onePayment(parts, 1000)
    expect([whole?.amount_minor, whole?.due_on, whole?.cues.length]).toEqual([1000, '2027-02-01', 2])
    expect(totalOf(parts)).toBe(1000)
  })

  test.each([
    ['extra_round_bp', '25 %', 2500, 2500],
    ['extra_round_bp', '12,5', 2500, 1250],
    ['hour_minor', 'EUR 80.00', 1, 8000],
    ['hour_minor', '80.001', 1, null],
    ['rounds_included', '1,000', 2, 1000],
    ['rounds_included', '2.5', 2, null],
    ['rounds_included', '', 2, null],
    ['court', 'Bern', '', 'Bern'],
  ])('%s typed as %s', (name, typed, before, wanted) => {
    expect(valueOf(name, typed, before, 'EUR')).toBe(wanted)
  })
})
