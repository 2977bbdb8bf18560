import { candidatesOf } from './candidates'
import { Select } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { categoriesQuery } from '@/api/project'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { type Project } from '../api'
import { type Member, useNameCategoryApprover } from './api'
import classes from './People.module.css'

/** The value of the project’s approver in a choice of approvers. */
const OF_PROJECT = 'project'

/** The approver of each category of the sound list: the project's, or one of its own. */
export function CategoriesCard({
  project,
  members = [],
}: {
  project: Project
  members: readonly Member[] | undefined
}) {
  const { data: categories, error } = useQuery(categoriesQuery(project.id))
  const name = useNameCategoryApprover(project.id)
  const named = new Map(project.category_approvers.map(({ category, approver }) => [category, approver]))
  const cues = new Map(categories?.map((row) => [row.category, row.cues]))
  const shown = [...new Set([...cues.keys(), ...named.keys()])].filter(Boolean).sort((a, b) => a.localeCompare(b))
  const choices = [
    { value: OF_PROJECT, label: `${project.approver.name} (project)` },
    ...candidatesOf(project, members)
      .filter(({ person }) => person.id !== project.approver.id)
      .map(({ person }) => ({ value: person.id, label: person.name })),
  ]
  const choose = (category: string, value: string | null) => {
    const before = named.get(category)?.id ?? null
    const personId = value === OF_PROJECT ? null : value
    if (value === null || personId === before || name.isPending) return
    name.mutate(
      { category, person_id: personId },
      {
        onSuccess: (changed) => {
          const approver = changed.category_approvers.find((row) => row.category === category)?.approver
          showToast(`${(approver ?? changed.approver).name} approves ${category} now.`, () =>
            name.mutate({ category, person_id: before }),
          )
        },
      },
    )
  }
  return (
    <Card aria-labelledby="categories">
      <CardHead id="categories" title="Categories" note="each may have its own approver" />
      <Refusal inset error={error ?? name.error} />
      {categories && shown.length === 0 && (
        <div className="p-inset">
          <EmptyState
            head="No categories yet"
            level={3}
            action={
              <Link
                className="link"
                to="/projects/$projectId/sound-list"
                params={{ projectId: project.id }}
                search={{}}
              >
                Go to the sound list
              </Link>
            }
          >
            {`${project.approver.name} approves every sound. Give cues a category to share the work.`}
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Categories">
        {shown.map((category) => (
          <Row key={category}>
            <div className="grow">
              <p className="strong">{category}</p>
              <p className="small mid">{plural(cues.get(category) ?? 0, 'cue')}</p>
            </div>
            {project.mine.is_producer ? (
              <Select
                aria-label={`Approver of ${category}`}
                className={classes.chosen}
                data={choices}
                value={named.get(category)?.id ?? OF_PROJECT}
                allowDeselect={false}
                onChange={(value) => choose(category, value)}
              />
            ) : (
              <p className="small">{(named.get(category) ?? project.approver).name}</p>
            )}
          </Row>
        ))}
      </Rows>
    </Card>
  )
}
