import { Checkbox, Select } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { projectQuery } from '@/api/project'
import { keptCuesQuery } from '@/api/soundList'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { planQuery } from '@/money/api'
import { minorOf, money } from '@/money/words'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'

import { type Contract, useContractAction } from './api'
import classes from './Contracts.module.css'

type Share = { share_bp: number } | { share_minor: number }

/** The two designers of joint work; on a draft, the second one is chosen, and the split is changed. */
export function JointCard({ contract }: { contract: Contract }) {
  const [opened, setOpened] = useState(false)
  const { joint, may } = contract
  if (joint.length === 0 && !(may.change && contract.kind === 'single')) return null
  const close = () => setOpened(false)
  return (
    <Card aria-labelledby="joint">
      <CardHead id="joint" title={joint.length === 0 ? 'Designers' : 'Joint work'} />
      {joint.length > 0 && <Parts contract={contract} />}
      <div className={classes.form}>
        {joint.length > 0 && <p className="small mid">{standing(contract)}</p>}
        {may.change && !opened && (
          <Button onClick={() => setOpened(true)}>
            {joint.length === 0 ? 'Add a second designer' : 'Change split'}
          </Button>
        )}
        {may.change && opened && joint.length === 0 && <SecondDesigner contract={contract} onClose={close} />}
        {may.change && opened && joint.length > 0 && <ChangeSplit contract={contract} onClose={close} />}
      </div>
    </Card>
  )
}

function standing({ state, waits_for, joint }: Contract): string {
  const other = joint.find(({ is_own }) => !is_own)?.designer.name ?? ''
  if (state === 'draft') return 'Both contracts are sent together. Each designer sees the other’s sounds and amount.'
  if (state === 'sent' && waits_for.length === 0)
    return `All have signed this one. It waits for the contract with ${other}.`
  if (state === 'sent') return 'Both contracts take effect together, once everyone has signed both.'
  return 'Each designer is paid for their own sounds, as they are accepted.'
}

function Parts({ contract }: { contract: Contract }) {
  return (
    <Rows aria-label="Joint work">
      {contract.joint.map(
        ({ designer, cues, amount_minor: minor, currency, share, contract_id: id, is_own: isOwn }) => (
          <Row key={designer.id} className={classes.row}>
            <div className="grow">
              <p>
                {id !== null && !isOwn ? (
                  <Link
                    className="link"
                    to="/projects/$projectId/contracts/$contractId"
                    params={{ projectId: contract.project_id, contractId: id }}
                  >
                    {designer.name}
                  </Link>
                ) : (
                  designer.name
                )}
              </p>
              <p className="small mid">{plural(cues, 'cue')}</p>
            </div>
            <span>{[money(minor, currency), share].filter(Boolean).join(', ')}</span>
          </Row>
        ),
      )}
    </Rows>
  )
}

/** "40 %" or "1,200.00"; undefined where nothing is typed, null where it is neither. */
export function shareOf(typed: string, currency: string): Share | null | undefined {
  const text = typed.trim()
  if (text === '') return undefined
  if (text.endsWith('%')) {
    const found = /^(\d{1,3})(?:[.,](\d{1,2}))?$/.exec(text.slice(0, -1).trim())
    const bp = found ? Number(found[1]) * 100 + Number((found[2] ?? '').padEnd(2, '0')) : 10_001
    return bp > 10_000 ? null : { share_bp: bp }
  }
  const minor = minorOf(text, currency)
  return minor === null || minor < 0 ? null : { share_minor: minor }
}

const WRONG_SHARE = 'Enter a percentage, such as 40 %, or an amount, such as 1,200.00.'

interface FormProps {
  contract: Contract
  onClose: () => void
}

function ChangeSplit({ contract, onClose }: FormProps) {
  const split = useContractAction(contract.id)
  return (
    <Form
      className={classes.inner}
      aria-label="Change split"
      initialValues={{ share: '' }}
      mutation={split}
      checks={({ share }) => ({ share: !shareOf(share, contract.currency) && WRONG_SHARE })}
      onSubmit={({ share }) => {
        const body = shareOf(share, contract.currency)
        if (!body) return
        split.mutate(
          { does: 'split', body },
          {
            onSuccess: () => {
              showToast('Saved the split.')
              onClose()
            },
          },
        )
      }}
    >
      <Field
        name="share"
        label={`Share of ${contract.designer.name}`}
        description="A percentage, such as 40 %, or an amount. The other designer gets the rest; each milestone is scaled."
        maxLength={20}
      />
      <Submit onCancel={onClose}>Save split</Submit>
    </Form>
  )
}

function SecondDesigner({ contract, onClose }: FormProps) {
  const divide = useContractAction(contract.id)
  const { data: project } = useQuery(projectQuery(contract.project_id))
  const { data: plan, error } = useQuery(planQuery(contract.id))
  const designers = (project?.engagements ?? []).filter(
    ({ ended_at, kind, designer }) => ended_at === null && kind !== 'in-house' && designer.id !== contract.designer.id,
  )
  const back = `/projects/${contract.project_id}`
  if (!project || !plan) return error ? <Refusal error={error} /> : <p className="mid">Loading…</p>
  if (designers.length === 0) {
    return (
      <Missing to={`${back}/people`} link="Invite a designer" onClose={onClose}>
        No other designer works on this project by contract. Invite one first.
      </Missing>
    )
  }
  const planned = plan.milestones.flatMap(({ cues }) => cues.map(({ cue }) => cue.id))
  if (planned.length < 2) {
    return (
      <Missing to={`${back}/contracts/${contract.id}/plan`} link="Plan milestones" onClose={onClose}>
        Plan the milestones of the whole work first. Then choose who makes which of its cues.
      </Missing>
    )
  }
  const nameOf = (engagement: string) => designers.find(({ id }) => id === engagement)?.designer.name ?? ''
  return (
    <DraftForm
      className={classes.inner}
      aria-label="Add a second designer"
      draftKey={`contract-joint:${contract.id}`}
      initialValues={{ engagement: designers[0]?.id ?? '', cueIds: [] as string[], share: '' }}
      mutation={divide}
      checks={({ share }) => ({ share: shareOf(share, contract.currency) === null && WRONG_SHARE })}
      onSubmit={({ engagement, cueIds, share }, onSent) => {
        if (cueIds.length === 0) return
        divide.mutate(
          {
            does: 'divide',
            body: { engagement_id: engagement, cue_ids: cueIds, ...shareOf(share, contract.currency) },
          },
          {
            onSuccess: () => {
              onSent()
              showToast(`Contract divided between ${contract.designer.name} and ${nameOf(engagement)}.`)
              onClose()
            },
          },
        )
      }}
    >
      {({ engagement, cueIds }, change) => (
        <>
          <p className="small mid">
            Each designer gets a contract of their own, for their own sounds. Both are sent and agreed together, and
            each designer sees the other’s sounds and amount.
          </p>
          <Field
            as={Select}
            name="engagement"
            label="Second designer"
            data={designers.map(({ id, designer }) => ({ value: id, label: designer.name }))}
            allowDeselect={false}
          />
          <CueChoice
            legend={`Cues that ${nameOf(engagement)} makes`}
            projectId={contract.project_id}
            planned={planned}
            chosen={cueIds}
            onChange={(ids) => change({ cueIds: ids })}
          />
          <Field
            optional
            name="share"
            label={`Share of ${nameOf(engagement)} (optional)`}
            description={`A percentage, such as 40 %, or an amount, of ${money(plan.price.total_minor, contract.currency)}. Without it the amounts follow the cues.`}
            maxLength={20}
          />
          <Submit onCancel={onClose}>{`Divide with ${nameOf(engagement)}`}</Submit>
        </>
      )}
    </DraftForm>
  )
}

interface MissingProps {
  to: string
  link: string
  onClose: () => void
  children: ReactNode
}

/** What must be there before a contract can be divided. */
function Missing({ to, link, onClose, children }: MissingProps) {
  return (
    <>
      <p>{children}</p>
      <div className={classes.buttons}>
        <ButtonLink component={Link} to={to}>
          {link}
        </ButtonLink>
        <Button variant="quiet" onClick={onClose}>
          Cancel
        </Button>
      </div>
    </>
  )
}

interface CueChoiceProps {
  legend: string
  projectId: string
  planned: readonly string[]
  chosen: readonly string[]
  onChange: (cueIds: string[]) => void
}

/** Cues of a plan, chosen by category or one by one. */
function CueChoice({ legend, projectId, planned, chosen, onChange }: CueChoiceProps) {
  const { data: cues, error } = useQuery(keptCuesQuery(projectId))
  const inPlan = new Set(planned)
  const plannedCues = (cues ?? []).filter(({ id }) => inPlan.has(id))
  const categories = new Set(plannedCues.map(({ category }) => category))
  const set = (ids: readonly string[], isChosen: boolean) => {
    const others = chosen.filter((id) => !ids.includes(id))
    onChange(isChosen ? [...others, ...ids] : others)
  }
  return (
    <fieldset
      className={`grid gap-2 min-w-0 m-0 p-0 border-0 ${classes.cueChoice}`}
      aria-busy={!cues && error === null}
    >
      <legend className="small strong">{legend}</legend>
      <Refusal error={error} />
      {[...categories].map((category) => {
        const ids = plannedCues.filter((cue) => cue.category === category).map(({ id }) => id)
        const count = ids.filter((id) => chosen.includes(id)).length
        return (
          <Checkbox
            key={category}
            label={`${category || 'No category'}, ${plural(ids.length, 'cue')}`}
            checked={count === ids.length}
            indeterminate={count > 0 && count < ids.length}
            onChange={({ currentTarget }) => set(ids, currentTarget.checked)}
          />
        )
      })}
      <details>
        <summary className="small">Choose single cues</summary>
        {plannedCues.map(({ id, label, name }) => (
          <Checkbox
            key={id}
            label={`${label} ${name}`}
            checked={chosen.includes(id)}
            onChange={({ currentTarget }) => set([id], currentTarget.checked)}
          />
        ))}
      </details>
      <p className="small mid">{`${chosen.length} of ${plural(planned.length, 'cue')} chosen`}</p>
    </fieldset>
  )
}
