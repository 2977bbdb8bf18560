import { Checkbox, Textarea, TextInput } from '@mantine/core'
import { Link, useParams } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { amount, minorOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { Select } from '@/ui/Select'

import {
  type Posting,
  useInvite,
  useMakeLink,
  useMovePosting,
  useRevokeLink,
  useSavePosting,
  useWithdrawCandidate,
} from './api'
import classes from './Hiring.module.css'
import { AskedCard } from './PostingFacts'
import { QuestionsCard } from './QuestionsCard'
import { Refusal } from './Refusal'
import { ChooseFromRoster } from './roster/ChooseFromRoster'
import { usePosting } from './usePosting'
import { STATE_WORDS } from './words'

/** One posting as the studio writes it: what it says, who is asked, and what they ask. */
export function PostingPage() {
  const { projectId, postingId } = useParams({ from: '/shell/projects/$projectId/postings/$postingId' })
  const { posting, missing } = usePosting(postingId)
  if (posting === undefined) return missing
  return (
    <div className={`page stack ${classes.sheet}`}>
      <Head posting={posting} projectId={projectId} />
      <AskedCard lines={posting.lines} />
      {posting.state !== 'awarded' && <Fields key={posting.revision} posting={posting} />}
      <PeopleCard posting={posting} />
      {posting.state !== 'awarded' && <ChooseFromRoster posting={posting} />}
      <QuestionsCard posting={posting} />
    </div>
  )
}

function Head({ posting, projectId }: { posting: Posting; projectId: string }) {
  const move = useMovePosting(posting.id)
  const { state, bids } = posting
  return (
    <div className="stack">
      <div>
        <h1>{posting.title}</h1>
        <p className="mid">
          {`${STATE_WORDS[state]}. ${plural(bids ?? 0, 'bid')}. `}
          {state === 'draft' && 'Next: say what you ask for, then open it. '}
          {state === 'open' && !posting.takes_bids && 'Its last day is over. Set a later one to take more bids. '}
          <Link className="link" to="/projects/$projectId/postings" params={{ projectId }}>
            All postings
          </Link>
        </p>
      </div>
      <div className="row wrap">
        {(state === 'draft' || state === 'closed') && (
          <Button
            variant={state === 'draft' ? 'primary' : 'plain'}
            aria-busy={move.isPending}
            onClick={() => move.mutate('open')}
          >
            {state === 'draft' ? 'Open for bids' : 'Open again'}
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
      </div>
      <Refusal error={move.error} />
    </div>
  )
}

const typed = (minor: number | null, currency: string) => (minor === null ? '' : amount(minor, currency))

function Fields({ posting }: { posting: Posting }) {
  const { currency } = posting
  const [now, set, draft] = useDraft(`posting:${posting.id}`, {
    title: posting.title,
    text: posting.text,
    phase: posting.phase,
    price: typed(posting.price_minor, currency),
    budget: typed(posting.budget_minor, currency),
    isShown: posting.is_budget_shown,
    floor: typed(posting.rate_floor_minor, currency),
    currency,
    categories: posting.categories.join(', '),
    until: posting.bids_until_on ?? '',
    from: posting.work_from_on ?? '',
    to: posting.work_to_on ?? '',
    headings: posting.headings.join('\n'),
  })
  const save = useSavePosting(posting.id)
  const [wrong, setWrong] = useState<string | null>(null)
  const isFixed = posting.state !== 'draft'
  const put = (changes: Partial<typeof now>) => set((before) => ({ ...before, ...changes }))
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (save.isPending) return
    const code = now.currency.trim().toUpperCase()
    if (!/^[A-Z]{3}$/.test(code)) return setWrong('Enter a currency of three letters, such as USD.')
    const sums = [now.price, now.budget, now.floor].map((text) => (text.trim() === '' ? null : minorOf(text, code)))
    const isUnread = [now.price, now.budget, now.floor].some((text, at) => text.trim() !== '' && sums[at] === null)
    if (isUnread) return setWrong(`Enter sums in ${code}, such as 1,200.00.`)
    setWrong(null)
    const categories = now.categories
      .split(',')
      .map((one) => one.trim())
      .filter(Boolean)
    const scope = posting.scope === 'cues' ? 'cues' : categories.length > 0 ? 'categories' : 'all'
    return save.mutate(
      {
        title: now.title,
        text: now.text,
        phase: now.phase,
        currency: code,
        price_minor: sums[0] ?? null,
        budget_minor: sums[1] ?? null,
        is_budget_shown: now.isShown,
        rate_floor_minor: sums[2] ?? null,
        scope,
        categories,
        cue_ids: posting.cue_ids,
        headings: now.headings
          .split('\n')
          .map((one) => one.trim())
          .filter(Boolean),
        bids_until_on: now.until || null,
        work_from_on: now.from || null,
        work_to_on: now.to || null,
        revision: posting.revision,
      },
      {
        onSuccess: () => {
          draft.discard()
          showToast('Posting saved.')
        },
      },
    )
  }
  return (
    <Card aria-labelledby="says">
      <CardHead id="says" title="What it says" />
      <form onSubmit={send} noValidate className={classes.form} aria-label="What it says">
        <div className={classes.wide}>
          <DraftNote draft={draft} />
        </div>
        <TextInput
          className={classes.wide}
          label="Title"
          value={now.title}
          maxLength={120}
          onChange={({ currentTarget }) => put({ title: currentTarget.value })}
        />
        <Textarea
          className={classes.wide}
          label="Text"
          rows={4}
          value={now.text}
          maxLength={5000}
          onChange={({ currentTarget }) => put({ text: currentTarget.value })}
        />
        <TextInput
          className={classes.wide}
          label="Categories"
          description={
            isFixed ? 'Fixed, since bids are made on it.' : 'Separated by commas. Left empty: all cues of the list.'
          }
          disabled={isFixed || posting.scope === 'cues'}
          value={now.categories}
          onChange={({ currentTarget }) => put({ categories: currentTarget.value })}
        />
        <Select
          label="Phase"
          value={now.phase}
          disabled={isFixed}
          onChange={({ currentTarget }) =>
            put({ phase: currentTarget.value === 'advisory' ? 'advisory' : 'production' })
          }
        >
          <option value="production">Production</option>
          <option value="advisory">Advice before production</option>
        </Select>
        <TextInput
          label="Currency"
          disabled={isFixed}
          value={now.currency}
          maxLength={3}
          onChange={({ currentTarget }) => put({ currency: currentTarget.value })}
        />
        {now.phase === 'advisory' && (
          <TextInput
            label="Price of the advice"
            inputMode="decimal"
            value={now.price}
            onChange={({ currentTarget }) => put({ price: currentTarget.value })}
          />
        )}
        <TextInput
          label="Budget"
          inputMode="decimal"
          value={now.budget}
          onChange={({ currentTarget }) => put({ budget: currentTarget.value })}
        />
        <TextInput
          label="Hourly floor"
          description="For the team: lower rates are pointed out."
          inputMode="decimal"
          value={now.floor}
          onChange={({ currentTarget }) => put({ floor: currentTarget.value })}
        />
        <TextInput
          label="Bids until"
          type="date"
          value={now.until}
          onChange={({ currentTarget }) => put({ until: currentTarget.value })}
        />
        <TextInput
          label="Work from"
          type="date"
          value={now.from}
          onChange={({ currentTarget }) => put({ from: currentTarget.value })}
        />
        <TextInput
          label="Work to"
          type="date"
          value={now.to}
          onChange={({ currentTarget }) => put({ to: currentTarget.value })}
        />
        <Checkbox
          className={classes.wide}
          label="Show the budget to designers"
          checked={now.isShown}
          onChange={({ currentTarget }) => put({ isShown: currentTarget.checked })}
        />
        <Textarea
          className={classes.wide}
          label="Headings that the team scores"
          description="One a line."
          rows={3}
          value={now.headings}
          onChange={({ currentTarget }) => put({ headings: currentTarget.value })}
        />
        <div className={classes.wide}>
          {wrong && <p role="alert">{wrong}</p>}
          <Refusal error={save.error} />
          <Button type="submit" variant="primary" aria-busy={save.isPending}>
            Save
          </Button>
        </div>
      </form>
    </Card>
  )
}

function PeopleCard({ posting }: { posting: Posting }) {
  const [email, setEmail, draft] = useDraft(`posting-candidate:${posting.id}`, '')
  const invite = useInvite(posting.id)
  const withdraw = useWithdrawCandidate(posting.id)
  const make = useMakeLink(posting.id)
  const revoke = useRevokeLink(posting.id)
  const isOver = posting.state === 'awarded'
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (invite.isPending || email.trim() === '') return
    invite.mutate(email, { onSuccess: () => draft.discard() })
  }
  return (
    <Card aria-labelledby="people">
      <CardHead id="people" title="Who is asked" count={posting.candidates.length} />
      <Rows>
        {posting.candidates.map(({ id, email: address, person, joined_at: joined, is_invited: isInvited }) => (
          <Row key={id}>
            <span className="grow cut-text">{person ? `${person.name} (${address})` : address}</span>
            <span className="mid">
              {joined ? `opened it on ${day(joined)}` : posting.state === 'draft' ? 'mailed when it opens' : 'mailed'}
              {isInvited ? '' : ', by the link'}
            </span>
            {!isOver && (
              <Button variant="quiet" aria-label={`Take ${address} off`} onClick={() => withdraw.mutate(id)}>
                Take off
              </Button>
            )}
          </Row>
        ))}
      </Rows>
      {!isOver && (
        <div className={classes.body}>
          <form onSubmit={send} noValidate className="row wrap" aria-label="Ask a designer">
            <TextInput
              className="grow"
              label="Email of a designer"
              type="email"
              value={email}
              onChange={({ currentTarget }) => setEmail(currentTarget.value)}
            />
            <Button type="submit" disabled={email.trim() === ''} aria-busy={invite.isPending}>
              Ask for a bid
            </Button>
          </form>
          <Refusal error={invite.error ?? withdraw.error ?? make.error ?? revoke.error} />
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
            <TextInput
              label="Link, shown this once"
              readOnly
              value={make.data.url}
              onFocus={(event) => event.currentTarget.select()}
            />
          )}
        </div>
      )}
    </Card>
  )
}
