import { Checkbox } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'

import { CardProblem } from './CardProblem'
import { membersSeeQuery, useSetMembersSee } from './membersSeeApi'

/** Whether members see all projects of the studio, or only those that they are in. */
export function MembersSeeCard({ studioId }: { studioId: string }) {
  const { data: sight, error } = useQuery(membersSeeQuery(studioId))
  const save = useSetMembersSee(studioId)
  const seen = save.isPending ? save.variables : sight?.members_see
  return (
    <Card aria-labelledby="members-see">
      <CardHead id="members-see" title="Projects" note="seen by members" />
      <CardProblem error={error ?? save.error} />
      {sight && (
        <fieldset className="p-3-4 m-0 border-0" disabled={save.isPending}>
          <legend className="visually-hidden">Projects that members see</legend>
          <Checkbox
            label="Only the projects they are in"
            description="Other members, including producers, cannot see a project that they are not in."
            checked={seen === 'own'}
            onChange={({ currentTarget }) =>
              save.mutate(currentTarget.checked ? 'own' : 'all', { onSuccess: () => showToast('Saved.') })
            }
          />
        </fieldset>
      )}
      <p className="small mid p-3-inset">
        The person who opens a project, its audio leads, approvers and deputies are added automatically. Add others
        under People. Any producer can change this setting, so it keeps no secret from producers.
      </p>
    </Card>
  )
}
