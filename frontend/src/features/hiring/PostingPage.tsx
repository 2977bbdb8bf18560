import { Checkbox, NativeSelect, Textarea, TextInput } from '@mantine/core'
import { Link, useParams } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { type Draft, DraftNote, useDraft } from '@/app/drafts'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { MailedLink } from '@/mails'
import { EffortLine } from '@/money/EffortLine'
import { amount, minorOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { CopyButton } from '@/ui/CopyButton'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day, plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'

import {
  type Posting,
  type PostingAdd,
  useInvite,
  useMakeLink,
  useMovePosting,
  useRevokeLink,
  useSavePosting,
  useWithdrawCandidate,
} from './api'
import classes from './Hiring.module.css'
import { AskedCard } from './AskedCard'
import { QuestionsCard } from './QuestionsCard'
import { ChooseFromRoster } from './roster/ChooseFromRoster'
import { usePosting } from './usePosting'
import { STATE_WORDS } from './words'

/** One posting as the studio writes it: what it says, who is asked, and what they ask. */
export function PostingPage() {
  const { projectId, postingId } = useParams({ from: '/shell/projects/$projectId/postings/$postingId' })
  const { posting, missing } = usePosting(postingId)
  const move = useMovePosting(postingId) // held here: a save draws the form anew before the posting opens
  if (posting === undefined) return missing
  return (
    <div className={`page stack ${classes.sheet}`}>
      {posting.state === 'awarded' ? (
        <>
          <Head posting={posting} projectId={projectId} move={move} />
          <AskedCard lines={posting.lines} postingId={posting.id} />
        </>
      ) : (
        <Written key={posting.revision} posting={posting} projectId={projectId} move={move} />
      )}
      <PeopleCard posting={posting} />
      {posting.state !== 'awarded' && <ChooseFromRoster posting={posting} />}
      <QuestionsCard posting={posting} />
    </div>
  )
}

type Move = ReturnType<typeof useMovePosting>

interface HeadProps {
  posting: Posting
  projectId: string
  move: Move
  /** What opens it; without it the posting is awarded, and stays as it is. */
  open?: { isChanged: boolean; isSaving: boolean; run: () => void }
  children?: ReactNode
}

function Head({ posting, projectId, move, open, children }: HeadProps) {
  const { state, bids } = posting
  return (
    <div className="stack">
      <PageHead
        title={posting.title}
        actions={
          <>
            {open && (state === 'draft' || state === 'closed') && (
              <Button
                variant={state === 'draft' ? 'primary' : 'plain'}
                aria-busy={move.isPending || open.isSaving}
                onClick={open.run}
              >
                {openWords(state, open.isChanged)}
              </Button>
            )}
            {state === 'open' && (
              <Button aria-busy={move.isPending} onClick={() => move.mutate('close')}>
                Close
              </Button>
            )}
            {(bids ?? 0) > 0 && (
              <Link
                className="link"
                to="/projects/$projectId/postings/$postingId/bids"
                params={{ projectId, postingId: posting.id }}
              >
                {`Compare ${plural(bids ?? 0, 'bid')}`}
              </Link>
            )}
            {posting.contract_id && (
              <Link
                className="link"
                to="/projects/$projectId/contracts/$contractId/draft"
                params={{ projectId, contractId: posting.contract_id }}
              >
                Open the draft contract
              </Link>
            )}
          </>
        }
      >
        {`${STATE_WORDS[state]}. ${plural(bids ?? 0, 'bid')}. `}
        {state === 'draft' && 'Next: say what you ask for, then open it. '}
        {state === 'open' && !posting.takes_bids && 'Bidding is closed. Set a later last day to take more bids. '}
        <Link className="link" to="/projects/$projectId/postings" params={{ projectId }}>
          All postings
        </Link>
      </PageHead>
      {children}
      <Refusal error={move.error} />
    </div>
  )
}

const openWords = (state: Posting['state'], isChanged: boolean) =>
  `${isChanged ? 'Save and open' : 'Open'} ${state === 'draft' ? 'for bids' : 'again'}`

const typed = (minor: number | null, currency: string) => (minor === null ? '' : amount(minor, currency))

const fieldsOf = (posting: Posting) => ({
  title: posting.title,
  text: posting.text,
  equipment: posting.equipment,
  phase: posting.phase,
  price: typed(posting.price_minor, posting.currency),
  budget: typed(posting.budget_minor, posting.currency),
  isShown: posting.is_budget_shown,
  floor: typed(posting.rate_floor_minor, posting.currency),
  currency: posting.currency,
  categories: posting.categories.join(', '),
  until: posting.bids_until_on ?? '',
  from: posting.work_from_on ?? '',
  to: posting.work_to_on ?? '',
  headings: posting.headings.join('\n'),
})
type PostingFields = ReturnType<typeof fieldsOf>

const partsOf = (text: string, separator: string) =>
  text
    .split(separator)
    .map((part) => part.trim())
    .filter(Boolean)

type PostingBody = PostingAdd & { revision: number }

/** What is typed as it is sent, or what cannot be read. */
function bodyOf(fields: PostingFields, posting: Posting): { body: PostingBody } | { wrong: string } {
  const currency = fields.currency.trim().toUpperCase()
  if (!/^[A-Z]{3}$/.test(currency)) return { wrong: 'Enter a currency of three letters, such as USD.' }
  const typedSums = [fields.price, fields.budget, fields.floor]
  const sums = typedSums.map((text) => (text.trim() === '' ? null : minorOf(text, currency)))
  const isUnread = typedSums.some((text, at) => text.trim() !== '' && sums[at] === null)
  if (isUnread) return { wrong: `Enter sums in ${currency}, such as 1,200.00.` }
  const categories = partsOf(fields.categories, ',')
  return {
    body: {
      title: fields.title,
      text: fields.text,
      equipment: fields.equipment,
      phase: fields.phase,
      currency,
      price_minor: sums[0] ?? null,
      budget_minor: sums[1] ?? null,
      is_budget_shown: fields.isShown,
      rate_floor_minor: sums[2] ?? null,
      scope: posting.scope === 'cues' ? 'cues' : categories.length > 0 ? 'categories' : 'all',
      categories,
      cue_ids: posting.cue_ids,
      headings: partsOf(fields.headings, '\n'),
      bids_until_on: fields.until || null,
      work_from_on: fields.from || null,
      work_to_on: fields.to || null,
      revision: posting.revision,
    },
  }
}

/** A posting that can still change: what opens it saves first what is typed. */
function Written({ posting, projectId, move }: { posting: Posting; projectId: string; move: Move }) {
  const saved = fieldsOf(posting)
  const [held, set, draft] = useDraft(`posting:${posting.id}`, saved)
  const isFixed = posting.state !== 'draft'
  // A draft may be older than the opening: what bids are made on is as it was opened.
  const fixed = isFixed ? { phase: saved.phase, currency: saved.currency, categories: saved.categories } : {}
  const fields = { ...held, ...fixed }
  const save = useSavePosting(posting.id)
  const [refused, setRefused] = useState<{ wrong: string | null; isOpening: boolean } | null>(null)
  const isBusy = save.isPending || move.isPending
  const keep = async (isOpening: boolean) => {
    const read = bodyOf(fields, posting)
    setRefused({ wrong: 'wrong' in read ? read.wrong : null, isOpening })
    if ('wrong' in read) return false
    const answer = await save.mutateAsync(read.body).catch(() => null)
    if (answer === null) return false
    draft.discard()
    return true
  }
  const open = async () => {
    if (isBusy || (draft.isChanged && !(await keep(true)))) return
    move.mutate('open')
  }
  const submit = async () => {
    if (!isBusy && (await keep(false))) showToast('Posting saved.')
  }
  const problem = refused && (
    <>
      {refused.wrong && <p role="alert">{refused.wrong}</p>}
      <Refusal error={save.error} />
    </>
  )
  return (
    <>
      <Head
        posting={posting}
        projectId={projectId}
        move={move}
        open={{ isChanged: draft.isChanged, isSaving: save.isPending, run: () => void open() }}
      >
        {refused?.isOpening && problem}
      </Head>
      <AskedCard lines={posting.lines} postingId={posting.id} />
      <Fields
        posting={posting}
        fields={fields}
        set={set}
        draft={draft}
        unsavedCurrency={held.currency === fields.currency ? null : held.currency}
        isSaving={save.isPending}
        onSubmit={() => void submit()}
      >
        {refused && !refused.isOpening && problem}
      </Fields>
    </>
  )
}

interface FieldsProps {
  posting: Posting
  fields: PostingFields
  set: (fields: PostingFields) => void
  draft: Draft
  /** The currency that was typed before the posting opened in another one. */
  unsavedCurrency: string | null
  isSaving: boolean
  onSubmit: () => void
  children: ReactNode
}

function Fields({ posting, fields, set, draft, unsavedCurrency, isSaving, onSubmit, children }: FieldsProps) {
  const isFixed = posting.state !== 'draft'
  return (
    <Card aria-labelledby="says">
      <CardHead id="says" title="What it says" />
      <Form
        className={`grid gap-4 ${classes.form}`}
        aria-label="What it says"
        initialValues={fields}
        values={fields}
        onValuesChange={set}
        mutation={{ isPending: isSaving, error: null }}
        onSubmit={onSubmit}
      >
        <div className={classes.wide}>
          <DraftNote draft={draft} />
        </div>
        <Field name="title" className={classes.wide} label="Title" maxLength={120} />
        <Field as={Textarea} optional name="text" className={classes.wide} label="Text" rows={4} maxLength={5000} />
        <Field
          optional
          name="equipment"
          className={classes.wide}
          label="Equipment that the work needs"
          maxLength={5000}
        />
        <Field
          optional
          name="categories"
          className={classes.wide}
          label="Categories"
          description={
            isFixed ? 'Fixed, since bids are made on it.' : 'Separated by commas. Left empty: all cues of the list.'
          }
          disabled={isFixed || posting.scope === 'cues'}
        />
        <Field
          as={NativeSelect}
          name="phase"
          label="Phase"
          disabled={isFixed}
          data={[
            { value: 'production', label: 'Production' },
            { value: 'advisory', label: 'Advice before production' },
          ]}
        />
        <Field
          optional
          name="currency"
          label="Currency"
          description={
            unsavedCurrency === null
              ? isFixed && 'Fixed, since bids are made on it.'
              : `Fixed: the posting was opened in ${fields.currency}, before ${unsavedCurrency} was saved.`
          }
          disabled={isFixed}
          maxLength={3}
        />
        {fields.phase === 'advisory' && <Field optional name="price" label="Price of the advice" inputMode="decimal" />}
        <Field optional name="budget" label="Budget" inputMode="decimal" />
        <Field
          optional
          name="floor"
          label="Hourly floor"
          description="For the team: lower rates are pointed out."
          inputMode="decimal"
        />
        <Field optional name="until" label="Bids until" type="date" />
        <Field optional name="from" label="Work from" type="date" />
        <Field optional name="to" label="Work to" type="date" />
        {fields.phase === 'production' && (
          <div className={classes.wide}>
            <EffortLine projectId={posting.project_id} postingId={posting.id} beginOn={fields.from} dueOn={fields.to} />
          </div>
        )}
        <Field as={Checkbox} name="isShown" className={classes.wide} label="Show the budget to designers" />
        <Field
          as={Textarea}
          optional
          name="headings"
          className={classes.wide}
          label="Headings that the team scores"
          description="One a line."
          rows={3}
        />
        <div className={classes.wide}>
          {children}
          <Submit>Save</Submit>
        </div>
      </Form>
    </Card>
  )
}

function PeopleCard({ posting }: { posting: Posting }) {
  const invite = useInvite(posting.id)
  const withdraw = useWithdrawCandidate(posting.id)
  const make = useMakeLink(posting.id)
  const revoke = useRevokeLink(posting.id)
  const isOver = posting.state === 'awarded'
  return (
    <Card aria-labelledby="people">
      <CardHead id="people" title="Who is asked" count={posting.candidates.length} />
      <Rows>
        {posting.candidates.map(({ id, email: address, person, joined_at: joined, is_invited: isInvited }) => (
          <Row key={id} className={classes.person}>
            <span className="grow cut-text">{person ? `${person.name} (${address})` : address}</span>
            <span className="mid">
              {[
                joined ? `opened it on ${day(joined)}` : posting.state === 'draft' ? 'asked when it opens' : '',
                isInvited ? '' : 'by the link',
              ]
                .filter(Boolean)
                .join(', ')}
            </span>
            {!joined && posting.state !== 'draft' && (
              <MailedLink projectId={posting.project_id} ofId={id} recipient={address} />
            )}
            {!isOver && (
              <Button variant="quiet" aria-label={`Take ${address} off`} onClick={() => withdraw.mutate(id)}>
                Remove
              </Button>
            )}
          </Row>
        ))}
      </Rows>
      {!isOver && (
        <div className={`grid gap-3 ${classes.body}`}>
          <DraftForm
            className="row wrap items-end"
            aria-label="Ask a designer"
            draftKey={`posting-candidate:${posting.id}`}
            initialValues={{ email: '' }}
            mutation={invite}
            onSubmit={({ email }, onSuccess) => invite.mutate(email, { onSuccess })}
          >
            <Field name="email" className="grow" label="Email of a designer" type="email" />
            <Submit variant="plain">Ask for a bid</Submit>
          </DraftForm>
          <Refusal error={withdraw.error ?? make.error ?? revoke.error} />
          <div className="row wrap">
            <Button aria-busy={make.isPending} onClick={() => make.mutate()}>
              {posting.has_link ? 'Make a new link' : 'Make a link for everyone'}
            </Button>
            {posting.has_link && (
              <Button variant="quiet" aria-busy={revoke.isPending} onClick={() => revoke.mutate()}>
                Revoke the link
              </Button>
            )}
          </div>
          {make.data && posting.has_link && (
            <div className="stack">
              <TextInput
                label="Link, shown this once"
                readOnly
                value={make.data.url}
                onFocus={(event) => event.currentTarget.select()}
              />
              <CopyButton text={make.data.url} what="Link">
                Copy link
              </CopyButton>
            </div>
          )}
        </div>
      )}
    </Card>
  )
}
