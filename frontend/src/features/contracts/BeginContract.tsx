import { Checkbox, Select, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import { useState } from 'react'

import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Form, Submit } from '@/ui/Form'
import { day } from '@/ui/format'

import {
  lastContractQuery,
  type ContractBrief,
  type ContractKind,
  type Project,
  templatesQuery,
  useBeginContract,
} from './api'
import classes from './Contracts.module.css'
import { isKind, KIND_MEANINGS, KIND_WORDS, KINDS } from './words'

const KIND_CHOICES = KINDS.map((kind) => ({ value: kind, label: `${KIND_WORDS[kind]}: ${KIND_MEANINGS[kind]}` }))
const LAST = 'last'
const LIBRARY = 'library'

/** What is taken over, and what is not with another designer. */
function saysLast(
  { designer, created_at: at }: { designer: { id: string; name: string }; created_at: string },
  withId?: string,
) {
  const whose = `With ${designer.name}, created ${day(at)}: its clauses, fees and terms.`
  return designer.id === withId ? whose : `${whose} Parties, tax and credit are left for you to fill in.`
}

/** Begin a draft with one designer: like the last contract, from the clause library, or from a template. */
export function BeginContract({ project, contracts }: { project: Project; contracts: readonly ContractBrief[] }) {
  const navigate = useNavigate()
  const begin = useBeginContract(project.id)
  const { data: templates } = useQuery(templatesQuery(project.studio.id))
  const designers = project.engagements.filter(({ ended_at, kind }) => ended_at === null && kind !== 'in-house')
  const [engagement, setEngagement] = useState<string | null>(null)
  const [kind, setKind] = useState<ContractKind>('single')
  const [currency, setCurrency] = useState<string | null>(null)
  const [source, setSource] = useState<string | null>(null)
  const [framework, setFramework] = useState<string | null>(null)
  const chosen = engagement ?? designers[0]?.id ?? null
  const agreesWith = designers.find(({ id }) => id === chosen)?.designer.id
  const frameworks = contracts.filter(
    (each) => each.kind === 'framework' && each.state === 'agreed' && each.designer.id === agreesWith,
  )
  const own = (templates ?? []).filter((each) => each.kind === kind)
  const { data: last } = useQuery({
    ...lastContractQuery(project.id, chosen ?? '', kind),
    enabled: chosen !== null,
  })
  const from = source ?? (last ? LAST : LIBRARY)
  const template = from === LAST || from === LIBRARY ? null : from
  const ofProject = contracts.at(-1)?.currency // the newest
  const money = currency ?? (from === LAST ? last?.currency : undefined) ?? ofProject ?? 'USD'
  const send = ({ title, music }: { title: string; music: boolean }) => {
    if (chosen === null) return
    const designer = designers.find(({ id }) => id === chosen)?.designer.name ?? ''
    begin.mutate(
      {
        engagement_id: chosen,
        kind,
        title: title.trim() || `${KIND_WORDS[kind]} with ${designer}`,
        currency: money.trim().toUpperCase(),
        template_id: template,
        same_as_id: from === LAST ? (last?.id ?? null) : null,
        framework_id: kind === 'statement_of_work' ? (framework ?? frameworks[0]?.id ?? null) : null,
        with_music: music,
      },
      {
        onSuccess: ({ id }) =>
          void navigate({
            to: '/projects/$projectId/contracts/$contractId/draft',
            params: { projectId: project.id, contractId: id },
          }),
      },
    )
  }
  return (
    <Card aria-labelledby="begin">
      <CardHead id="begin" title="New contract" />
      {designers.length === 0 ? (
        <div className="p-inset">
          <EmptyState head="No designer to contract yet" level={3}>
            Invite a designer on the People page first. In-house designers need no contract.
          </EmptyState>
        </div>
      ) : (
        <Form
          className={classes.form}
          aria-label="New contract"
          initialValues={{ title: '', music: false }}
          mutation={begin}
          onSubmit={send}
        >
          <Select
            label="With"
            data={designers.map(({ id, designer }) => ({ value: id, label: designer.name }))}
            value={chosen}
            allowDeselect={false}
            onChange={(id) => {
              setEngagement(id)
              setFramework(null)
              setSource(null)
            }}
          />
          <Select
            label="Kind"
            data={KIND_CHOICES}
            value={kind}
            allowDeselect={false}
            onChange={(value) => {
              if (!isKind(value)) return
              setKind(value)
              setSource(null)
            }}
          />
          {kind === 'statement_of_work' && (
            <Select
              label="Framework agreement"
              data={frameworks.map(({ id, title: name }) => ({ value: id, label: name }))}
              value={framework ?? frameworks[0]?.id ?? null}
              placeholder="No framework agreement is signed yet"
              onChange={setFramework}
            />
          )}
          <Field optional name="title" label="Title (optional)" maxLength={120} />
          <TextInput
            label="Currency"
            description="Three letters, such as USD or EUR"
            value={money}
            maxLength={3}
            onChange={({ currentTarget }) => setCurrency(currentTarget.value)}
          />
          {(last || own.length > 0) && (
            <Select
              label="Start from"
              description={from === LAST && last ? saysLast(last, agreesWith) : undefined}
              data={[
                ...(last ? [{ value: LAST, label: `Same as last contract: ${last.title}` }] : []),
                { value: LIBRARY, label: 'Clause library' },
                ...own.map(({ id, name }) => ({ value: id, label: name })),
              ]}
              value={from}
              allowDeselect={false}
              onChange={setSource}
            />
          )}
          {kind !== 'nda' && from === LIBRARY && (
            <Field as={Checkbox} name="music" label="Includes music (ancillary rights, editions, soundtrack)" />
          )}
          <p className="small mid">A starting point for both parties’ lawyers, not legal advice.</p>
          <Submit>Create draft</Submit>
        </Form>
      )}
    </Card>
  )
}
