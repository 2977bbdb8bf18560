import { expect, test } from 'vitest'

import { paysMinor, planOf, type TypedPlan, withDeposit } from './plan'

const CUES = ['ping', 'oath', 'roar'].map((id) => ({ id, name: id }))
const milestone = (key: string, amount: string, isDeposit = false) => ({
  key,
  name: key,
  dueOn: '',
  amount,
  tax: '',
  isDeposit,
})
const PLAN: TypedPlan = {
  milestones: [milestone('Alpha', '3,000.00'), milestone('Beta', '')],
  cues: {
    ping: { milestone: 'Beta', price: '1,000.00', hours: '' },
    oath: { milestone: 'Beta', price: '2,390.01', hours: '' },
    roar: { milestone: 'Alpha', price: '', hours: '' },
  },
}
const paysOf = (typed: TypedPlan) => {
  const { plan, faults } = planOf(typed, CUES as never, 'EUR')
  expect(faults).toEqual([])
  return plan.milestones.map(paysMinor)
}

test('a deposit is taken out of the price and not added to it', () => {
  expect(paysOf(PLAN)).toEqual([300_000, 339_001])
  const pays = paysOf(withDeposit(PLAN, paysOf(PLAN), 'EUR'))
  expect(pays[0]).toBe(127_801)
  expect(pays.reduce((sum, one) => sum + one, 0)).toBe(639_001)
})

test('a deposit that was there is made anew', () => {
  const typed = { ...PLAN, milestones: [milestone('Advance', '10.00', true), ...PLAN.milestones] }
  const after = withDeposit(typed, paysOf(typed), 'EUR')
  expect(after.milestones.map(({ name, isDeposit }) => [name, isDeposit])).toEqual([
    ['Advance', true],
    ['Alpha', false],
    ['Beta', false],
  ])
  expect(paysOf(after).reduce((sum, one) => sum + one, 0)).toBe(640_001)
})
