import { Checkbox, Textarea, TextInput } from '@mantine/core'
import { Link, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { OwnTimeCard } from '@/money/OwnTimeCard'
import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { Select } from '@/ui/Select'

import { type BidLine, type Posting, useAsk, useSaveBid, useSendBid, useWithdrawBid } from './api'
import { conceptsOf, contentOf, perHourOf, totalOf, type TypedLine, typedBid } from './bid'
import classes from './Hiring.module.css'
import { PostingFacts } from './PostingFacts'
import { EXCLUSIVITY_WORDS } from './roster/words'
import { SamplesCard } from './SamplesCard'
import { StudioRecordCard } from './StudioRecordCard'
import { usePosting } from './usePosting'
import { EXTRA_WORDS, UNIT_WORDS } from './words'

/** A posting as a designer sees it, with their own bid. */
export function BidPage() {
  const { postingId } = useParams({ from: '/shell/postings/$postingId' })
  const { posting, missing } = usePosting(postingId)
  const send = useSendBid(postingId) // held here: a save draws the form anew, and what refused the bid stays
  if (posting === undefined) return missing
  if (posting.is_team) {
    return (
      <div className={`page stack ${classes.sheet}`}>
        <h1>{posting.title}</h1>
        <p>
          Your studio posted this.{' '}
          <Link
            className="link"
            to="/projects/$projectId/postings/$postingId"
            params={{ projectId: posting.project_id, postingId }}
          >
            Open it in the project
          </Link>
        </p>
      </div>
    )
  }
  return (
    <div className={`page stack ${classes.sheet}`}>
      <PostingFacts posting={posting} ndaOpen={posting.nda_open} postingId={posting.id} />
      <StudioRecordCard postingId={posting.id} />
      {posting.clashes.length > 0 && <Clashes posting={posting} />}
      {!posting.nda_open && (
        <>
          <BidForm key={posting.own_bid?.revision ?? 0} posting={posting} send={send} />
          <SamplesCard posting={posting} />
          <Questions posting={posting} />
        </>
      )}
      <OwnTimeCard projectId={posting.project_id} postingId={posting.id} />
    </div>
  )
}

function Clashes({ posting }: { posting: Posting }) {
  return (
    <section aria-label="Days in common" className="tone-warn">
      {posting.clashes.map(({ title, is_awarded: isAwarded, from_on: from, to_on: to }) => (
        <p key={title}>
          <span className="toned">{isAwarded ? 'You are booked' : 'You have a bid out'}</span>
          {` for ${title}, ${day(from)} to ${day(to)}. Only you see this.`}
        </p>
      ))}
    </section>
  )
}

function standOf({ own_bid: bid, state }: Posting): string {
  if (bid === null) return 'Not sent yet'
  if (bid.is_awarded) return 'Chosen. A contract follows'
  if (state === 'awarded') return 'Another bid was chosen. Thank you'
  if (bid.state === 'sent') return bid.differs ? 'Sent; what you changed since is not' : 'Sent'
  return bid.state === 'withdrawn' ? 'Withdrawn' : 'Draft, not sent yet'
}

function BidForm({ posting, send }: { posting: Posting; send: ReturnType<typeof useSendBid> }) {
  const { currency, own_bid: own, takes_bids: isTaking } = posting
  const [now, set, draft] = useDraft(`bid:${posting.id}`, () => typedBid(posting.lines, own?.content ?? null, currency))
  const [wrong, setWrong] = useState<string | null>(null)
  const save = useSaveBid(posting.id)
  const withdraw = useWithdrawBid(posting.id)
  const labels = new Map(posting.lines.map(({ key, label }) => [key, label]))
  const put = (changes: Partial<typeof now>) => set((before) => ({ ...before, ...changes }))
  const perHour = perHourOf(now, currency)
  const concepts = conceptsOf(now, posting.lines, currency)
  const missing = now.lines.filter(({ kind, isOffered }) => kind === 'asked' && !isOffered)
  const keep = async (thenSend: boolean) => {
    if (save.isPending || send.isPending || !isTaking) return
    const read = contentOf(now, currency)
    if ('wrong' in read) return setWrong(read.wrong)
    setWrong(null)
    const saved = await save.mutateAsync({ ...read.content, revision: own?.revision ?? 0 }).catch(() => null)
    if (saved === null) return
    draft.discard()
    if (!thenSend) return showToast('Draft saved. The studio does not see it.')
    const sent = await send.mutateAsync(saved.own_bid?.revision ?? 0).catch(() => null)
    if (sent !== null) showToast('Bid sent.')
  }
  useHotkeys([
    { keys: 'mod+Enter', label: 'Send the bid', group: 'Bid', run: () => void keep(true), disabled: !isTaking },
  ])
  const change = (at: number, changes: Partial<TypedLine>) =>
    put({ lines: now.lines.map((line, place) => (place === at ? { ...line, ...changes } : line)) })
  return (
    <Card aria-labelledby="bid">
      <CardHead id="bid" title="Your bid" note={standOf(posting)} />
      <div className={`grid gap-3 ${classes.body}`}>
        <DraftNote draft={draft} />
        {own?.is_awarded ? (
          <p>
            Next: read and sign the contract once the studio sends it. You get an email.{' '}
            <Link className="link" to="/projects/$projectId/desk" params={{ projectId: posting.project_id }}>
              Go to your desk
            </Link>
          </p>
        ) : (
          !isTaking && <p>This posting takes no bids now. What you have typed is kept.</p>
        )}
      </div>
      {now.lines.map((line, at) => (
        <LineFields
          key={`${line.kind}-${at}`}
          line={line}
          name={line.kind === 'asked' ? (labels.get(line.key) ?? line.key) : EXTRA_WORDS[line.kind]}
          currency={currency}
          onChange={(changes) => change(at, changes)}
          onRemove={() => put({ lines: now.lines.filter((_, place) => place !== at) })}
        />
      ))}
      <div className={`grid gap-4 ${classes.form}`}>
        <Select
          label="Add an extra"
          value=""
          onChange={({ currentTarget }) => {
            const kind = currentTarget.value as Exclude<BidLine['kind'], 'asked'>
            put({
              lines: [
                ...now.lines,
                { key: '', kind, unit: 'flat', quantity: '1', price: '', note: '', isOffered: true },
              ],
            })
          }}
        >
          <option value="" disabled>
            Choose
          </option>
          {Object.entries(EXTRA_WORDS).map(([kind, word]) => (
            <option key={kind} value={kind}>
              {word}
            </option>
          ))}
        </Select>
        <TextInput
          label="Hours in all"
          inputMode="decimal"
          value={now.hours}
          onChange={({ currentTarget }) => put({ hours: currentTarget.value })}
        />
        <TextInput
          label="From"
          type="date"
          value={now.from}
          onChange={({ currentTarget }) => put({ from: currentTarget.value })}
        />
        <TextInput
          label="To"
          type="date"
          value={now.to}
          onChange={({ currentTarget }) => put({ to: currentTarget.value })}
        />
        <Select
          label="Other projects while it lasts"
          value={now.exclusivity}
          onChange={({ currentTarget }) => put({ exclusivity: currentTarget.value as typeof now.exclusivity })}
        >
          {Object.entries(EXCLUSIVITY_WORDS).map(([value, words]) => (
            <option key={value} value={value}>
              {words}
            </option>
          ))}
        </Select>
        <TextInput
          label="Other work in these days"
          maxLength={5000}
          value={now.otherWork}
          onChange={({ currentTarget }) => put({ otherWork: currentTarget.value })}
        />
        {(posting.equipment !== '' || now.equipment !== '') && (
          <TextInput
            className={classes.wide}
            label="Equipment"
            description={posting.equipment && `The studio asks for: ${posting.equipment}`}
            maxLength={5000}
            value={now.equipment}
            onChange={({ currentTarget }) => put({ equipment: currentTarget.value })}
          />
        )}
        <Textarea
          className={classes.wide}
          label="Note"
          rows={2}
          maxLength={5000}
          value={now.note}
          onChange={({ currentTarget }) => put({ note: currentTarget.value })}
        />
      </div>
      <p className="items-baseline flex wrap gap-3 p-14px">
        <span className="strong">{`Total ${money(totalOf(now, currency), currency)}`}</span>
        {perHour !== null && (
          <span className="small mid">{`${money(perHour, currency)} an hour of the whole work`}</span>
        )}
        {concepts > 0 && (
          <span className="tone-warn">{`${money(concepts, currency)} of it for cues that are concepts still`}</span>
        )}
        {missing.length > 0 && (
          <span className="mid">{`without ${missing.map(({ key }) => labels.get(key) ?? key).join(', ')}`}</span>
        )}
      </p>
      <div className={`grid gap-3 ${classes.body}`}>
        {wrong && <p role="alert">{wrong}</p>}
        <Refusal error={save.error ?? send.error ?? withdraw.error} />
        <div className="row wrap">
          <Button
            variant="primary"
            keys="mod+Enter"
            disabled={!isTaking}
            aria-busy={send.isPending}
            onClick={() => void keep(true)}
          >
            {own?.state === 'sent' ? 'Send again' : 'Send'}
          </Button>
          <Button disabled={!isTaking} aria-busy={save.isPending} onClick={() => void keep(false)}>
            Save draft
          </Button>
          {own?.state === 'sent' && posting.state !== 'awarded' && (
            <Button variant="quiet" aria-busy={withdraw.isPending} onClick={() => withdraw.mutate(undefined)}>
              Withdraw
            </Button>
          )}
        </div>
        <p className="small mid">The studio sees your bid once you send it. No other designer sees your rates.</p>
      </div>
    </Card>
  )
}

interface LineFieldsProps {
  line: TypedLine
  name: string
  currency: string
  onChange: (changes: Partial<TypedLine>) => void
  onRemove: () => void
}

function LineFields({ line, name, currency, onChange, onRemove }: LineFieldsProps) {
  const isOff = !line.isOffered
  return (
    <fieldset className={`grid items-end gap-3 m-0 ${classes.line}`}>
      <legend className="visually-hidden">{name}</legend>
      {line.kind === 'asked' ? (
        <Checkbox
          label={name}
          checked={line.isOffered}
          onChange={({ currentTarget }) => onChange({ isOffered: currentTarget.checked })}
        />
      ) : (
        <TextInput
          label={name}
          placeholder="What it is for"
          value={line.key}
          maxLength={200}
          onChange={({ currentTarget }) => onChange({ key: currentTarget.value })}
        />
      )}
      <Select
        label="Counted"
        value={line.unit}
        disabled={isOff}
        onChange={({ currentTarget }) => onChange({ unit: currentTarget.value as BidLine['unit'] })}
      >
        {Object.entries(UNIT_WORDS).map(([unit, word]) => (
          <option key={unit} value={unit}>
            {word}
          </option>
        ))}
      </Select>
      <TextInput
        label="How many"
        inputMode="decimal"
        disabled={isOff || line.unit === 'flat'}
        value={line.unit === 'flat' ? '1' : line.quantity}
        onChange={({ currentTarget }) => onChange({ quantity: currentTarget.value })}
      />
      <TextInput
        label={`Price, ${currency}`}
        inputMode="decimal"
        disabled={isOff}
        value={line.price}
        onChange={({ currentTarget }) => onChange({ price: currentTarget.value })}
      />
      <span className="mid">{isOff ? 'not offered' : ''}</span>
      {line.kind === 'asked' ? (
        <span />
      ) : (
        <Button variant="quiet" onClick={onRemove} aria-label={`Remove ${name}`}>
          Remove
        </Button>
      )}
    </fieldset>
  )
}

function Questions({ posting }: { posting: Posting }) {
  const [text, setText, draft] = useDraft(`posting-question:${posting.id}`, '')
  const ask = useAsk(posting.id)
  return (
    <Card aria-labelledby="questions">
      <CardHead id="questions" title="Questions" count={posting.questions.length} />
      {posting.questions.map(({ id, text: asked, answer, asked_by: by }) => (
        <div key={id} className={`grid gap-3 ${classes.body}`}>
          <p>
            {by === null && <span className="mid">Another designer asked: </span>}
            {asked}
          </p>
          <p className="mid">{answer ?? 'Waiting for an answer'}</p>
        </div>
      ))}
      <div className={`grid gap-3 ${classes.body}`}>
        <Textarea
          label="Ask the studio"
          maxLength={2000}
          value={text}
          onChange={({ currentTarget }) => setText(currentTarget.value)}
        />
        <Refusal error={ask.error} />
        <div>
          <Button
            disabled={text.trim() === ''}
            aria-busy={ask.isPending}
            onClick={() => ask.mutate(text, { onSuccess: () => draft.discard() })}
          >
            Ask
          </Button>
        </div>
      </div>
    </Card>
  )
}
