import { Checkbox } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'

import { CardProblem } from './CardProblem'
import { requirementQuery, type SecondFactorUse, useSetRequirement } from './secondFactorApi'

const USES: readonly { use: SecondFactorUse; label: string; hint: string }[] = [
  { use: 'signing', label: 'Signing contracts', hint: 'change orders and statements too, by either party' },
  { use: 'paying', label: 'Paying', hint: 'payments, refunds, and what makes an amount due at once' },
  { use: 'everything', label: 'Everything', hint: 'members open nothing of the studio without one' },
]

/** What the studio requires a second factor for. */
export function SecondFactorRequirementCard({ studioId }: { studioId: string }) {
  const { data: requirement, error } = useQuery(requirementQuery(studioId))
  const save = useSetRequirement(studioId)
  const chosen = new Set(save.isPending ? save.variables : requirement?.required_for)
  return (
    <Card aria-labelledby="second-factor-requirement">
      <CardHead id="second-factor-requirement" title="Second factor" note="required for" />
      <CardProblem error={error ?? save.error} />
      {requirement && (
        <fieldset className="grid gap-3 p-3-4 m-0 border-0" disabled={save.isPending}>
          <legend className="visually-hidden">Second factor required for</legend>
          {USES.map(({ use, label, hint }) => (
            <Checkbox
              key={use}
              label={label}
              description={hint}
              checked={chosen.has(use)}
              onChange={({ currentTarget }) => {
                const uses = USES.map((option) => option.use).filter((candidate) =>
                  candidate === use ? currentTarget.checked : chosen.has(candidate),
                )
                save.mutate(uses, { onSuccess: () => showToast('Saved.') })
              }}
            />
          ))}
        </fieldset>
      )}
      <p className="small mid p-3-inset">
        Who has none is told so where it is asked for. Everyone sets up their own on the Account page.
      </p>
    </Card>
  )
}
