import { describe, expect, test } from 'vitest'

import type { ListedCue, Plan } from '@/money/api'

import { moved, paysMinor, planOf, typedOf, type TypedPlan } from './plan'

const CUES = ['radar_ping', 'dock_clamp'].map((name) => ({ id: name, name })) as ListedCue[]
const typed = (more: Partial<TypedPlan['milestones'][number]> = {}): TypedPlan => ({
  milestones: [{ key: 'm', name: 'Alpha', dueOn: '2026-12-01', amount: '', tax: '', isDeposit: false, ...more }],
  cues: {
    radar_ping: { milestone: 'm', price: '180', hours: '1.5' },
    dock_clamp: { milestone: 'm', price: '120.50', hours: '' },
  },
})

describe('what is typed', () => {
  test('is sent in minor units and minutes; without an amount the prices add up', () => {
    const { plan, faults } = planOf(typed({ tax: '7.5' }), CUES, 'USD')
    expect(faults).toEqual([])
    expect(plan.milestones).toEqual([
      {
        name: 'Alpha',
        due_on: '2026-12-01',
        is_deposit: false,
        amount_minor: null,
        tax_bp: 750,
        cues: [
          { cue_id: 'radar_ping', price_minor: 18_000, estimate_min: 90 },
          { cue_id: 'dock_clamp', price_minor: 12_050, estimate_min: null },
        ],
      },
    ])
    expect(plan.milestones.map(paysMinor)).toEqual([30_050])
  })

  test('and cannot be read is said where it stands, with how to write it', () => {
    const said = planOf({ ...typed({ amount: 'much', name: ' ' }), cues: {} }, CUES, 'USD').faults
    expect(said.map(({ where }) => where)).toEqual(['milestones.0', 'milestones.0'])
    expect(said[0]?.message).toBe('Enter a name.')
    expect(said[1]?.message).toBe('“much” is not an amount in USD. Write it like 1,440.00.')
    expect(planOf(typed({ tax: '120' }), CUES, 'USD').faults).toHaveLength(1)
    expect(planOf(typed({ amount: '-5' }), CUES, 'USD').faults).toHaveLength(1)
  })

  test('as a deposit has neither day nor cues', () => {
    const [deposit] = planOf(typed({ isDeposit: true, amount: '1,440' }), CUES, 'USD').plan.milestones
    expect(deposit).toMatchObject({ is_deposit: true, due_on: null, cues: [], amount_minor: 144_000 })
  })
})

test('what was saved comes back as it was typed', () => {
  const cue = (id: string, price: number) => ({
    cue: { id, label: '', name: id },
    price_minor: price,
    estimate_min: 90,
  })
  const milestone = {
    id: 'm',
    name: 'Alpha',
    due_on: '2026-12-01',
    amount_minor: 30_050,
    tax_bp: 750,
    is_deposit: false,
  }
  const saved = {
    currency: 'USD',
    milestones: [{ ...milestone, cues: [cue('radar_ping', 18_000), cue('dock_clamp', 12_050)] }],
  } as unknown as Plan
  const back = typedOf(saved)
  expect(back.milestones).toEqual([
    { key: 'm', name: 'Alpha', dueOn: '2026-12-01', amount: '', tax: '7.5', isDeposit: false },
  ])
  expect(back.cues.radar_ping).toEqual({ milestone: 'm', price: '180.00', hours: '1.5' })
  expect(planOf(back, CUES, 'USD').plan.milestones[0]?.cues).toHaveLength(2)
})

test('milestones change places, and stay at the ends', () => {
  expect(moved(['a', 'b', 'c'], 2, -1)).toEqual(['a', 'c', 'b'])
  expect(moved(['a', 'b'], 1, 1)).toEqual(['a', 'b'])
  expect(moved(['a', 'b'], 0, -1)).toEqual(['a', 'b'])
})
