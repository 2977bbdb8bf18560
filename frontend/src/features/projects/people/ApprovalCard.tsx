import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { categoriesQuery } from '@/api/project'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

import type { Project } from '../api'
import { approvalSettingsQuery, useSetBlockers, useSetChecklist } from './api'
import { linesOf } from '../words'
import classes from './People.module.css'

const BLOCKERS = [
  { value: 'none', label: 'Nothing' },
  { value: 'notes', label: 'Open notes' },
  { value: 'items', label: 'Unchecked items' },
  { value: 'both', label: 'Open notes and unchecked items' },
] as const

const nameOf = (category: string) => category || 'every cue'

/** What is checked of a version before it is approved, and what blocks its approval. */
export function ApprovalCard({ project }: { project: Project }) {
  const { data: settings, error } = useQuery(approvalSettingsQuery(project.id))
  const { data: categories } = useQuery(categoriesQuery(project.id))
  const block = useSetBlockers(project.id)
  const [category, setCategory] = useState('')
  const lists = new Map(
    settings?.checklists.map((checklist) => [checklist.category, checklist.items.map(({ text }) => text)]),
  )
  const choices = [...new Set([...lists.keys(), ...(categories ?? []).map((row) => row.category)])].filter(Boolean)
  const isProducer = project.mine.is_producer
  return (
    <Card aria-labelledby="before-approval">
      <CardHead id="before-approval" title="Before approval" note="checklists, and what blocks" />
      <Refusal inset error={error ?? block.error} />
      {settings && (
        <div className="grid gap-3 p-3-inset-4">
          {isProducer ? (
            <Select
              label="A version is not approved while it has"
              value={settings.blockers}
              disabled={block.isPending}
              onChange={({ currentTarget }) => {
                const chosen = BLOCKERS.find(({ value }) => value === currentTarget.value)
                if (chosen)
                  block.mutate(chosen.value, { onSuccess: () => showToast(`Blocks approval: ${chosen.label}.`) })
              }}
            >
              {BLOCKERS.map(({ value, label }) => (
                <option key={value} value={value}>
                  {label}
                </option>
              ))}
            </Select>
          ) : (
            <p>
              <span className="mid">Blocks approval:</span>{' '}
              {BLOCKERS.find(({ value }) => value === settings.blockers)?.label}
            </p>
          )}
          <p className="small mid">
            Open notes are comments that are not resolved, and notes on earlier versions that are not done. A contract’s
            clause on silence and an adoption are not blocked.
          </p>
          <Select label="Checklist of" value={category} onChange={(event) => setCategory(event.currentTarget.value)}>
            {['', ...choices.sort((a, b) => a.localeCompare(b))].map((option) => (
              <option key={option} value={option}>
                {`${option === '' ? 'Every cue' : option} (${lists.get(option)?.length ?? 0})`}
              </option>
            ))}
          </Select>
          {isProducer ? (
            <ChecklistForm
              key={category}
              projectId={project.id}
              category={category}
              items={lists.get(category) ?? []}
            />
          ) : (
            <Items items={lists.get(category) ?? []} />
          )}
        </div>
      )}
    </Card>
  )
}

function Items({ items }: { items: readonly string[] }) {
  if (items.length === 0) return <p className="small mid">No items</p>
  return (
    <ul aria-label="Items">
      {items.map((text) => (
        <li key={text}>{text}</li>
      ))}
    </ul>
  )
}

interface ChecklistFormProps {
  projectId: string
  category: string
  items: readonly string[]
}

function ChecklistForm({ projectId, category, items }: ChecklistFormProps) {
  const saved = items.join('\n')
  const write = useSetChecklist(projectId)
  return (
    <DraftForm
      className={`grid gap-3 ${classes.checklist}`}
      draftKey={`checklist:${projectId}:${category}:${saved}`}
      initialValues={{ items: saved }}
      mutation={write}
      onSubmit={({ items: text }, onSent) =>
        write.mutate(
          { category, items: linesOf(text) },
          {
            onSuccess: () => {
              onSent()
              showToast(`The checklist of ${nameOf(category)} is saved.`)
            },
          },
        )
      }
    >
      {({ items: text }) => (
        <>
          <Field
            as={Textarea}
            optional
            name="items"
            label={`Items for ${nameOf(category)}`}
            description="One a line. An item that stays as it is keeps its checks."
            rows={6}
          />
          <Submit variant="plain" disabled={text === saved}>
            Save checklist
          </Submit>
        </>
      )}
    </DraftForm>
  )
}
