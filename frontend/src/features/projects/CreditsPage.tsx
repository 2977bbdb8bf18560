import { Checkbox } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'

import { DraftForm } from '@/app/drafts/DraftForm'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'

import { type Credit, type Credits, creditsQuery, useAddCredit, useRemoveCredit, useSaveMyCredit } from './credits'
import classes from './Credits.module.css'

/** Who worked on the project, by role, as each wants to be named. */
export function CreditsPage() {
  useTitle('Credits')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/credits' })
  const { data, error } = useQuery(creditsQuery(projectId))
  const isTeam = data?.is_team ?? false
  return (
    <div className="page">
      <PageHead
        title="Credits"
        actions={
          isTeam && (
            <p className="flex wrap gap-2">
              <ButtonLink icon="download" href={`/v1/projects/${projectId}/credits.txt`} download>
                Text
              </ButtonLink>
              <ButtonLink icon="download" href={`/v1/projects/${projectId}/credits.csv`} download>
                CSV
              </ButtonLink>
            </p>
          )
        }
      >
        {isTeam ? 'Who worked on the sound, for the game’s credits.' : 'How the game’s credits name you.'}
      </PageHead>
      <Refusal inset error={error} />
      {data && (
        <div className="columns">
          <div className="stack">
            <RolesCard credits={data} projectId={projectId} />
            {data.is_editor && <AddCard projectId={projectId} />}
          </div>
          <aside aria-label="Your name">
            <MyCard key={`${data.my_name} ${String(data.am_left_out)}`} credits={data} projectId={projectId} />
          </aside>
        </div>
      )}
    </div>
  )
}

function RolesCard({ credits: { credits, left_out: leftOut, is_editor: isEditor }, projectId }: CardProps) {
  const remove = useRemoveCredit(projectId)
  const roles = [...new Set(credits.map(({ role }) => role))]
  return (
    <Card aria-label="Credits by role">
      <CardHead title="By role" count={credits.length} end={leftOut > 0 && `${plural(leftOut, 'person')} left out`} />
      <Refusal inset error={remove.error} />
      {credits.length === 0 && (
        <EmptyState head="No credits yet">Sound designers are listed once a sound of theirs is approved.</EmptyState>
      )}
      {roles.map((role) => (
        <section key={role} aria-label={role}>
          <h3 className={`small mid ${classes.role}`}>{role}</h3>
          <Rows aria-label={role}>
            {credits
              .filter((credit) => credit.role === role)
              .map((credit) => (
                <Row key={credit.line_id ?? `${credit.person_id} ${role}`}>
                  <Named credit={credit} />
                  {isEditor && credit.line_id && (
                    <Button
                      variant="quiet"
                      icon="cross"
                      aria-label={`Remove ${credit.name}, ${role}`}
                      disabled={remove.isPending}
                      onClick={() => credit.line_id && remove.mutate(credit.line_id)}
                    />
                  )}
                </Row>
              ))}
          </Rows>
        </section>
      ))}
    </Card>
  )
}

function Named({ credit: { name, agreed_line: agreed } }: { credit: Credit }) {
  return (
    <span className="grow">
      <span className="strong">{name}</span>
      {agreed !== '' && <span className="small mid block wrap-anywhere">The contract says: {agreed}</span>}
    </span>
  )
}

interface CardProps {
  credits: Credits
  projectId: string
}

function MyCard({ credits, projectId }: CardProps) {
  const save = useSaveMyCredit(projectId)
  return (
    <Card aria-labelledby="my-credit">
      <CardHead id="my-credit" title="Your name in the credits" />
      <DraftForm
        className="grid gap-3 p-3-inset-4"
        aria-label="Your name in the credits"
        draftKey={`credit:${projectId}`}
        initialValues={{ name: credits.my_name, is_left_out: credits.am_left_out }}
        mutation={save}
        onSubmit={(mine, onSent) =>
          save.mutate(mine, {
            onSuccess: () => {
              onSent()
              showToast(mine.is_left_out ? 'You are left out of the credits.' : 'Your name in the credits is saved.')
            },
          })
        }
      >
        {(mine) => (
          <>
            <Field
              optional
              name="name"
              label="Name"
              description={`Empty: ${credits.my_account_name}, as in your account`}
              maxLength={120}
              disabled={mine.is_left_out}
            />
            <Field as={Checkbox} name="is_left_out" label="Leave me out of the credits" />
            <Submit>Save</Submit>
          </>
        )}
      </DraftForm>
    </Card>
  )
}

function AddCard({ projectId }: { projectId: string }) {
  const add = useAddCredit(projectId)
  return (
    <Card aria-labelledby="add-credit">
      <CardHead id="add-credit" title="Add a name" note="performers, voices, musicians" />
      <DraftForm
        className={`grid items-end gap-3 p-3-inset-4 ${classes.add}`}
        aria-label="Add a name"
        draftKey={`credit-line:${projectId}`}
        initialValues={{ role: '', name: '' }}
        mutation={add}
        onSubmit={(line, onSuccess) => add.mutate(line, { onSuccess })}
      >
        <Field name="role" label="Role" maxLength={120} />
        <Field name="name" label="Name" maxLength={120} />
        <Submit variant="plain" icon="plus">
          Add name
        </Submit>
      </DraftForm>
    </Card>
  )
}
