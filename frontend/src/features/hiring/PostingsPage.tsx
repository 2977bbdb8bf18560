import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'

import { DraftForm } from '@/app/drafts/DraftForm'
import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'

import { type PostingAdd, type PostingSummary, postingsQuery, useCreatePosting } from './api'
import classes from './Hiring.module.css'
import { STATE_WORDS } from './words'

/** The postings of a project, and the beginning of another. */
export function PostingsPage() {
  useTitle('Postings')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/postings' })
  const { data: postings, error } = useQuery(postingsQuery(projectId))
  return (
    <div className={`page stack ${classes.sheet}`} aria-busy={!postings && error === null}>
      <PageHead title="Postings">
        Offer work of this project to designers, compare their bids, and award one. You can also{' '}
        <Link className="link" to="/projects/$projectId/people" params={{ projectId }}>
          invite a designer directly
        </Link>
        , or look on the{' '}
        <Link className="link" to="/roster">
          roster
        </Link>
        .
      </PageHead>
      <Refusal error={error} />
      {postings && (
        <>
          <Card aria-labelledby="postings">
            <CardHead id="postings" title="All postings" count={postings.length} />
            {postings.length === 0 ? (
              <EmptyState head="No posting yet" level={3}>
                A posting counts what it asks for from the sound list. Nobody sees it before you open it.
              </EmptyState>
            ) : (
              <Rows>
                {postings.map((posting) => (
                  <Row key={posting.id}>
                    <Link
                      className="link grow"
                      to="/projects/$projectId/postings/$postingId"
                      params={{ projectId, postingId: posting.id }}
                    >
                      {posting.title}
                    </Link>
                    <span className="mid">{standOf(posting)}</span>
                    <span>{plural(posting.bids ?? 0, 'bid')}</span>
                  </Row>
                ))}
              </Rows>
            )}
          </Card>
          <NewPosting projectId={projectId} />
        </>
      )}
    </div>
  )
}

function standOf({ state, takes_bids: takesBids, bids_until_on: until }: PostingSummary): string {
  if (state !== 'open') return STATE_WORDS[state]
  if (!takesBids) return 'Bidding closed'
  return until ? `Open until ${day(until)}` : 'Open'
}

/** A posting to begin from: all cues of the list, and the project's currency and the headings by the server's choice. */
const newPosting = (title: string): PostingAdd => ({
  title,
  text: '',
  equipment: '',
  phase: 'production',
  is_budget_shown: false,
  scope: 'all',
})

function NewPosting({ projectId }: { projectId: string }) {
  const create = useCreatePosting(projectId)
  const navigate = useNavigate()
  return (
    <Card aria-labelledby="new-posting">
      <CardHead id="new-posting" title="New posting" />
      <DraftForm
        className={`grid gap-3 ${classes.body}`}
        aria-label="New posting"
        draftKey={`posting:${projectId}`}
        initialValues={{ title: '' }}
        mutation={create}
        onSubmit={({ title }, onSent) =>
          create.mutate(newPosting(title), {
            onSuccess: ({ id }) => {
              onSent()
              void navigate({ to: '/projects/$projectId/postings/$postingId', params: { projectId, postingId: id } })
            },
          })
        }
      >
        <Field
          name="title"
          label="Title"
          description="What designers read first, such as Effects for Alpha."
          maxLength={120}
        />
        <Submit icon="plus">Create posting</Submit>
      </DraftForm>
    </Card>
  )
}
