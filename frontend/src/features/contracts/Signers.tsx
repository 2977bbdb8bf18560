import { Select } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { studioPeopleQuery, projectQuery } from '@/api/project'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'

import { type Contract, useContractAction } from './api'
import classes from './Contracts.module.css'

type Party = 'studio' | 'designer'
const ORDERS: { value: string; label: string }[] = [
  { value: 'either', label: 'Either side' },
  { value: 'studio', label: 'The studio' },
  { value: 'designer', label: 'The designer' },
]
const isParty = (value: string | null): value is Party => value === 'studio' || value === 'designer'

/** Who signs for the studio and in which order: set on a draft, shown from then on. */
export function Signers({ contract }: { contract: Contract }) {
  if (contract.may.change) return <ChooseSigners contract={contract} />
  if (contract.signers.length === 0 && contract.signs_first === null) return null
  return (
    <Card aria-labelledby="signers">
      <CardHead id="signers" title="Who signs" />
      <Rows aria-label="Who signs">
        {contract.signers.map(({ id, name }, at) => (
          <Row key={id} className={classes.row}>
            <span className="grow">{`${at + 1}. ${name}, for the studio`}</span>
          </Row>
        ))}
        {contract.signs_first !== null && (
          <Row className={classes.row}>
            <span className="grow">{`The ${contract.signs_first} signs first.`}</span>
          </Row>
        )}
      </Rows>
    </Card>
  )
}

function ChooseSigners({ contract }: { contract: Contract }) {
  return (
    <Card aria-labelledby="signers">
      <CardHead id="signers" title="Who signs" />
      <div className={classes.form}>
        <SignerFields contract={contract} />
      </div>
    </Card>
  )
}

/** Who signs a draft for the studio, and which side signs first; saved at once. */
export function SignerFields({ contract }: { contract: Contract }) {
  const { data: project } = useQuery(projectQuery(contract.project_id))
  const { data: people, error } = useQuery({
    ...studioPeopleQuery(project?.studio.id ?? ''),
    enabled: project !== undefined,
  })
  const set = useContractAction(contract.id)
  const producers = (people ?? [])
    .filter(({ person, roles }) => roles.includes('producer') && person.id !== contract.designer.id)
    .map(({ person }) => ({ value: person.id, label: person.name }))
  const [first = null, second = null] = contract.signers.map(({ id }) => id)
  const save = (personIds: (string | null)[], order: Party | null) =>
    set.mutate(
      { does: 'sign order', body: { person_ids: personIds.filter((id) => id !== null), first: order } },
      { onSuccess: () => showToast('Saved who signs.') },
    )
  return (
    <>
      <Select
        label="First signer of the studio"
        placeholder="Any producer"
        data={producers.filter(({ value }) => value !== second)}
        value={first}
        clearable
        onChange={(id) => save(id === null ? [] : [id, second], contract.signs_first)}
      />
      {first !== null && (
        <Select
          label="Second signer of the studio"
          placeholder="None"
          data={producers.filter(({ value }) => value !== first)}
          value={second}
          clearable
          onChange={(id) => save([first, id], contract.signs_first)}
        />
      )}
      <Select
        label="Signs first"
        data={ORDERS}
        value={contract.signs_first ?? 'either'}
        allowDeselect={false}
        onChange={(value) => save([first, second], isParty(value) ? value : null)}
      />
      <Refusal error={error ?? set.error} />
    </>
  )
}
