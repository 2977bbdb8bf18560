import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { Dialog } from '@/app/Dialog'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { plural, shortDay, today } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'

import forms from '../Hiring.module.css'
import { period } from '../words'
import {
  workQuery,
  type Entry,
  entryQuery,
  type PostingChoice,
  postingsToAskQuery,
  useAskForBids,
  useRemoveEntry,
} from './api'
import { AvailabilityCard } from './AvailabilityCard'
import { EntryForm } from './EntryForm'
import { FiguresCard } from './FiguresCard'
import { LoansCard } from './LoansCard'
import { ReelCard } from './ReelCard'
import classes from './Roster.module.css'
import { busyInWords } from './words'

/** One designer on file: what is known of them, when they are free, their reel, and asking them for a bid. */
export function EntryPage() {
  const { entryId } = useParams({ from: '/shell/roster/$entryId' })
  const { data: entry, error } = useQuery(entryQuery(entryId))
  const navigate = useNavigate()
  useTitle(entry?.name ?? 'Roster')
  useHotkeys([
    { keys: 'Escape', label: 'Back to the roster', group: 'Roster', run: () => void navigate({ to: '/roster' }) },
  ])
  if (entry === undefined) {
    return (
      <div className="page stack" aria-busy={error === null}>
        {error && <h1>Roster</h1>}
        <Refusal error={error} />
      </div>
    )
  }
  return (
    <div className="page stack">
      <Head entry={entry} />
      <div className="columns">
        <div className="stack">
          <EntryForm key={entry.revision} entry={entry} />
        </div>
        <div className="stack">
          <AskCard entry={entry} />
          <AvailabilityCard key={entry.id} entry={entry} />
          <ReelCard entry={entry} />
          <LoansCard entry={entry} />
          <WorkCard entry={entry} />
        </div>
      </div>
    </div>
  )
}

function Head({ entry }: { entry: Entry }) {
  const [removing, setRemoving] = useState(false)
  const remove = useRemoveEntry(entry.id)
  const navigate = useNavigate()
  const isFree = entry.free_from_on <= today()
  return (
    <PageHead
      title={entry.name}
      actions={
        <>
          <Button variant="quiet" onClick={() => setRemoving(true)}>
            Remove from the roster
          </Button>
          {removing && (
            <Dialog title={`Remove ${entry.name} from the roster?`} opened onClose={() => setRemoving(false)}>
              <div className="grid gap-3">
                <p>
                  Everything noted here is deleted: facts, notes, dates and reel. Projects, bids and contracts stay as
                  they are.
                </p>
                <Refusal error={remove.error} />
                <div className="row">
                  <Button data-autofocus onClick={() => setRemoving(false)}>
                    Keep
                  </Button>
                  <Button
                    variant="primary"
                    aria-busy={remove.isPending}
                    onClick={() =>
                      remove.mutate(undefined, {
                        onSuccess: () => {
                          showToast(`${entry.name} was removed from the roster.`)
                          void navigate({ to: '/roster' })
                        },
                      })
                    }
                  >
                    Remove
                  </Button>
                </div>
              </div>
            </Dialog>
          )}
        </>
      }
    >
      <a className="link" href={`mailto:${entry.email}`}>
        {entry.email}
      </a>
      {`, ${isFree ? 'free now' : `free from ${shortDay(entry.free_from_on)}`}. `}
      <Link className="link" to="/roster">
        The roster
      </Link>
    </PageHead>
  )
}

/** The postings that the designer can be asked about, with clashes of dates. */
function AskCard({ entry }: { entry: Entry }) {
  const { data: postings, error } = useQuery(postingsToAskQuery(entry.id))
  return (
    <Card aria-labelledby="ask" aria-busy={postings === undefined && error === null}>
      <CardHead id="ask" title="Ask for a bid" />
      <Refusal error={error} />
      {postings?.length === 0 && (
        <p className={`mid grid gap-3 ${forms.body}`}>
          No posting is open or in draft. Write one on a project’s page first.
        </p>
      )}
      <Rows>
        {postings?.map((posting) => (
          <AskRow key={posting.id} entry={entry} posting={posting} />
        ))}
      </Rows>
    </Card>
  )
}

function AskRow({ entry, posting }: { entry: Entry; posting: PostingChoice }) {
  const ask = useAskForBids(posting.id)
  const [clash, ...more] = posting.clashes
  return (
    <Row className={classes.posting}>
      <div className="grow">
        <Link
          className="link"
          to="/projects/$projectId/postings/$postingId"
          params={{ projectId: posting.project_id, postingId: posting.id }}
        >
          {posting.title}
        </Link>
        <p className="small mid">{`${posting.project_name}, ${period(posting.work_from_on, posting.work_to_on)}`}</p>
        {clash && (
          <p className="small tone-warn">
            <span className="toned">
              {`Busy ${busyInWords(clash)}${more.length > 0 ? `, and ${plural(more.length, 'more range')}` : ''}`}
            </span>
          </p>
        )}
        <Refusal error={ask.error} />
      </div>
      {posting.is_asked ? (
        <span className="mid">asked</span>
      ) : (
        <Button
          icon="mail"
          aria-label={`Ask ${entry.name} for a bid on ${posting.title}`}
          aria-busy={ask.isPending}
          onClick={() =>
            ask.mutate([entry.id], {
              onSuccess: () =>
                showToast(
                  posting.state === 'draft'
                    ? `${entry.name} is asked when the posting opens.`
                    : `${entry.name} is asked. The posting has their link, and says how the email stands.`,
                ),
            })
          }
        >
          Ask
        </Button>
      )}
    </Row>
  )
}

function WorkCard({ entry }: { entry: Entry }) {
  const { data: figures, error } = useQuery({ ...workQuery(entry.id), enabled: entry.designer !== null })
  if (entry.designer === null) {
    return (
      <Card aria-labelledby="work">
        <CardHead id="work" title="Track record with us" />
        <p className={`mid grid gap-3 ${forms.body}`}>
          No account with this address has worked for the studio yet. Figures appear here once one does.
        </p>
      </Card>
    )
  }
  return (
    <>
      <Refusal error={error} />
      {figures && (
        <FiguresCard
          figures={figures}
          title="Track record with us"
          note="computed; the designer sees the same"
          linksProjects
        />
      )}
    </>
  )
}
