import { Checkbox, NativeSelect, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useEffect, useRef, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { minorOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { sentence } from '@/ui/sentence'

import { type Change, type ChangeOffer, type ChangeOrders, changePreviewQuery, useChangeOrder } from './api'
import classes from './Contracts.module.css'
import { DifferenceView } from './DifferenceView'
import { Warning } from './Warning'

type Kind = Change['kind']
const KINDS: Record<Kind, string> = {
  add_cue: 'Add a cue',
  cut_cue: 'Take a cue out',
  reprice_cue: 'Change the price of a cue',
  add_round: 'Add a round of a cue',
  move_date: 'Move a date',
  add_work: 'Add work beside the cues',
  set_caps: 'Set the caps of hours or days',
}
type CapName = keyof NonNullable<ChangeOrders['caps']>
const CAPS: { name: CapName; label: string }[] = [
  { name: 'hours_cap', label: 'Hours at most in all' },
  { name: 'hours_month_cap', label: 'Hours at most in a month' },
  { name: 'days_cap', label: 'Days at most in all' },
]
const isKind = (value: string): value is Kind => value in KINDS

/** A change that was put together, and the offer that it takes up. */
interface Made {
  change: Change
  offer: string | null
}

interface ProposeChangeProps {
  all: ChangeOrders
  /** An offer that a change order is begun from. */
  picked: ChangeOffer | null
  onBegun: () => void
}

/** A new change order, change by change, with what it does while it is written. */
export function ProposeChange({ all, picked, onBegun }: ProposeChangeProps) {
  const propose = useChangeOrder(all.contract_id)
  const [made, setMade] = useState<Made[]>([])
  const [begun, setBegun] = useState<ChangeOffer | null>(null)
  const [isTyped, setTyped] = useState(false)
  const [reason, setReason, draft] = useDraft(`change-order:${all.contract_id}`, '')
  const [beginsAtOnce, setBeginsAtOnce] = useState(false)
  const reasonField = useRef<HTMLInputElement>(null)
  const changes = made.map(({ change }) => change)
  useEffect(() => {
    if (picked === null) return
    const whole = wholeChange(picked.change)
    setBegun(whole === null ? picked : null)
    if (whole !== null) {
      setMade((before) => [
        ...before.filter(({ offer }) => offer !== picked.offer),
        { change: whole, offer: picked.offer },
      ])
      reasonField.current?.focus()
    }
    setReason((typed) => (typed.includes(picked.text) ? typed : `${typed} ${picked.text}`.trim()))
    onBegun()
  }, [picked, onBegun, setReason])
  const { data: preview, error } = useQuery(changePreviewQuery(all.contract_id, changes))
  const problems = preview?.problems ?? []
  const isReady = changes.length > 0 && reason.trim() !== '' && problems.length === 0 && !isTyped
  const submit = (event: FormEvent) => {
    event.preventDefault()
    if (propose.isPending || !isReady) return
    propose.mutate(
      {
        does: 'propose',
        reason: reason.trim(),
        beginsAtOnce,
        changes,
        offers: made.flatMap(({ offer }) => offer ?? []),
      },
      {
        onSuccess: () => {
          setMade([])
          setBegun(null)
          setBeginsAtOnce(false)
          draft.discard()
        },
      },
    )
  }
  return (
    <Card aria-labelledby="propose">
      <CardHead id="propose" title="Propose a change order" />
      <OneChange
        key={begun?.offer ?? ''}
        all={all}
        start={begun?.change}
        onTyped={setTyped}
        onAdd={(change) => {
          setMade([
            ...made,
            { change, offer: begun !== null && change.kind === begun.change.kind ? begun.offer : null },
          ])
          setBegun(null)
        }}
      />
      <form onSubmit={submit} className={classes.form} aria-label="Propose a change order">
        {problems.map((problem) => (
          <Warning key={problem}>{sentence(problem)}</Warning>
        ))}
        {changes.length > 0 && preview?.difference && (
          <DifferenceView difference={preview.difference} currency={all.currency} />
        )}
        {changes.length > 0 && (
          <Button variant="quiet" onClick={() => setMade(made.slice(0, -1))}>
            Remove the last change
          </Button>
        )}
        <TextInput
          ref={reasonField}
          label="Reason"
          value={reason}
          maxLength={2000}
          onChange={({ currentTarget }) => setReason(currentTarget.value)}
        />
        <DraftNote draft={draft} />
        <Checkbox
          label="Work may begin before both have signed, at our risk"
          checked={beginsAtOnce}
          onChange={({ currentTarget }) => setBeginsAtOnce(currentTarget.checked)}
        />
        {isTyped && changes.length > 0 && (
          <Warning>A change is typed above and not added. Add it, or clear it, before you propose.</Warning>
        )}
        <Refusal error={propose.error ?? error} />
        <Button type="submit" variant="primary" disabled={!isReady} aria-busy={propose.isPending}>
          Propose
        </Button>
      </form>
    </Card>
  )
}

interface OneChangeProps {
  all: ChangeOrders
  /** What the form begins with. */
  start?: ChangeOffer['change'] | undefined
  /** Whether something is typed that is not added yet. */
  onTyped: (isTyped: boolean) => void
  onAdd: (change: Change) => void
}

function OneChange({ all, start, onTyped, onAdd }: OneChangeProps) {
  const [kind, setKind] = useState<Kind>(start?.kind ?? firstKind(all))
  const [cueId, setCueId] = useState(start?.cue_id ?? '')
  const [milestoneId, setMilestoneId] = useState(start?.milestone_id ?? '')
  const [price, setPrice] = useState('')
  const [dueOn, setDueOn] = useState('')
  const [text, setText] = useState(start?.text ?? '')
  const [typedCaps, setTypedCaps] = useState<Partial<Record<CapName, string>>>({})
  const priceField = useRef<HTMLInputElement>(null)
  useEffect(() => {
    if (start) priceField.current?.focus()
  }, [start])
  const isTyped =
    [price, dueOn, text].some((typed) => typed.trim() !== '') || Object.values(typedCaps).some((typed) => typed !== '')
  useEffect(() => onTyped(isTyped), [isTyped, onTyped])
  const cues = kind === 'add_cue' ? all.cues_to_add : all.cues.map(({ cue }) => cue)
  const hasCue = kind !== 'move_date' && kind !== 'add_work' && kind !== 'set_caps'
  const hasMilestone = kind === 'add_cue' || kind === 'move_date' || kind === 'add_work'
  const hasPrice = kind === 'add_cue' || kind === 'reprice_cue' || kind === 'add_work'
  const cue = cues.some(({ id }) => id === cueId) ? cueId : (cues[0]?.id ?? '')
  const milestone = all.milestones.some(({ id }) => id === milestoneId) ? milestoneId : (all.milestones[0]?.id ?? '')
  const minor = minorOf(price, all.currency)
  const change = changeOf(kind, {
    cue,
    milestone,
    minor,
    dueOn,
    text: text.trim(),
    caps: changedCaps(all.caps, typedCaps),
  })
  const submit = (event: FormEvent) => {
    event.preventDefault()
    if (change === null) return
    onAdd(change)
    setPrice('')
    setDueOn('')
    setText('')
    setTypedCaps({})
  }
  return (
    <form onSubmit={submit} className={classes.form} aria-label="One change">
      <NativeSelect
        label="Change"
        value={kind}
        data={Object.entries(KINDS)
          .filter(([value]) => value !== 'set_caps' || all.caps !== null)
          .map(([value, label]) => ({ value, label }))}
        onChange={({ currentTarget }) => isKind(currentTarget.value) && setKind(currentTarget.value)}
      />
      {hasCue && (
        <NativeSelect
          label="Cue"
          value={cue}
          data={cues.map(({ id, label, name }) => ({ value: id, label: `${label} ${name}` }))}
          description={cues.length === 0 ? 'There is none that could be named here.' : undefined}
          onChange={({ currentTarget }) => setCueId(currentTarget.value)}
        />
      )}
      {hasMilestone && (
        <NativeSelect
          label="Milestone"
          value={milestone}
          data={all.milestones.map(({ id, name }) => ({ value: id, label: name }))}
          onChange={({ currentTarget }) => setMilestoneId(currentTarget.value)}
        />
      )}
      {kind === 'set_caps' &&
        CAPS.filter(({ name }) => capOf(all.caps, name) !== null).map(({ name, label }) => (
          <TextInput
            key={name}
            label={label}
            inputMode="numeric"
            value={typedCaps[name] ?? String(capOf(all.caps, name))}
            onChange={({ currentTarget }) => setTypedCaps({ ...typedCaps, [name]: currentTarget.value })}
          />
        ))}
      {kind === 'add_work' && (
        <TextInput
          label="Work"
          placeholder="Voice session, two hours"
          value={text}
          maxLength={200}
          onChange={({ currentTarget }) => setText(currentTarget.value)}
        />
      )}
      {hasPrice && (
        <TextInput
          ref={priceField}
          label={`Price in ${all.currency}`}
          inputMode="decimal"
          value={price}
          onChange={({ currentTarget }) => setPrice(currentTarget.value)}
        />
      )}
      {kind === 'move_date' && (
        <TextInput
          label="New date"
          type="date"
          value={dueOn}
          onChange={({ currentTarget }) => setDueOn(currentTarget.value)}
        />
      )}
      <Button type="submit" icon="plus" disabled={change === null}>
        Add this change
      </Button>
    </form>
  )
}

/** What most contracts of this kind change first. */
function firstKind(all: ChangeOrders): Kind {
  if (all.cues_to_add.length > 0) return 'add_cue'
  return all.cues.length === 0 && all.caps !== null ? 'set_caps' : 'reprice_cue'
}

const capOf = (caps: ChangeOrders['caps'], name: CapName) => caps?.[name] ?? null

/** The caps that were typed and differ from those that stand; null where none differs or one is not a number. */
function changedCaps(caps: ChangeOrders['caps'], typed: Partial<Record<CapName, string>>) {
  const changed: Partial<Record<CapName, number>> = {}
  for (const { name } of CAPS) {
    const text = typed[name]?.trim()
    if (text === undefined || text === String(capOf(caps, name))) continue
    if (!/^[1-9]\d{0,4}$/.test(text)) return null
    changed[name] = Number(text)
  }
  return Object.keys(changed).length > 0 ? changed : null
}

/** The change that an offer says whole, null where the party has to name a price. */
function wholeChange({
  kind,
  cue_id: cue,
  milestone_id: milestone,
  due_on: dueOn,
}: ChangeOffer['change']): Change | null {
  return changeOf(kind, {
    cue: cue ?? '',
    milestone: milestone ?? '',
    minor: null,
    dueOn: dueOn ?? '',
    text: '',
    caps: null,
  })
}

interface Given {
  cue: string
  milestone: string
  minor: number | null
  dueOn: string
  text: string
  caps: Partial<Record<CapName, number>> | null
}

/** The change that a form says, null while it is not whole. */
function changeOf(kind: Kind, { cue, milestone, minor, dueOn, text, caps }: Given): Change | null {
  switch (kind) {
    case 'add_cue':
      if (cue === '' || milestone === '' || minor === null) return null
      return { kind, cue_id: cue, milestone_id: milestone, price_minor: minor }
    case 'reprice_cue':
      return cue === '' || minor === null ? null : { kind, cue_id: cue, price_minor: minor }
    case 'cut_cue':
    case 'add_round':
      return cue === '' ? null : { kind, cue_id: cue }
    case 'move_date':
      return milestone === '' || dueOn === '' ? null : { kind, milestone_id: milestone, due_on: dueOn }
    case 'add_work':
      if (milestone === '' || text === '' || minor === null || minor < 1) return null
      return { kind, milestone_id: milestone, text, amount_minor: minor }
    case 'set_caps':
      return caps === null ? null : { kind, ...caps }
  }
}
