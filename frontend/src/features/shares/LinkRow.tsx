import { TextInput } from '@mantine/core'
import { useInfiniteQuery } from '@tanstack/react-query'
import { useId, useState } from 'react'

import { useMutation } from '@/api'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { ago, day, plural } from '@/ui/format'
import { Row } from '@/ui/Rows'

import { type GuestLink, readAddress, useChangeLink, useRevokeLink, visitsQuery } from './api'
import { CopyAddress } from './CopyAddress'
import { dayAfter, endOfDay } from './days'
import classes from './Shares.module.css'

const STATES: Record<GuestLink['state'], string> = {
  open: 'Open',
  revoked: 'Revoked',
  expired: 'Expired',
  full: 'Opened as often as it may be',
}

/** "3 sounds, password, comments, beeps, until Friday 10 December". */
function termsOf(link: GuestLink): string {
  return [
    plural(link.sounds, 'sound'),
    link.has_password && 'password',
    link.may_comment ? 'comments' : 'listen only',
    link.has_beeps && 'beeps',
    link.expires_at && `until ${day(link.expires_at)}`,
    link.max_openings !== null && `at most ${plural(link.max_openings, 'opening')}`,
  ]
    .filter(Boolean)
    .join(', ')
}

/** One guest link: whether it opens, who heard what by it, and how it ends. */
export function LinkRow({ projectId, link }: { projectId: string; link: GuestLink }) {
  const [opened, setOpened] = useState(false)
  const panelId = useId()
  const address = useMutation({ mutationFn: () => readAddress(link.id) })
  const revoke = useRevokeLink(projectId, link.id)
  return (
    <Row className={classes.link}>
      <div className="flex wrap items-center gap-1-3">
        <button
          type="button"
          className={`flex items-center flex-1 min-w-0 min-h-28px p-0 font-inherit bg-none border-0 pointer narrow-min-h-44px ${classes.sound}`}
          aria-expanded={opened}
          aria-controls={panelId}
          onClick={() => setOpened(!opened)}
        >
          <span className="strong cut-text">{link.title}</span>
          <span className={`small nowrap ${link.state === 'open' ? 'tone-ok toned' : 'dim'}`}>
            {STATES[link.state]}
          </span>
        </button>
        <span className="small mid nowrap">
          {plural(link.openings, 'opening')}, {plural(link.plays, 'play')}
        </span>
        <span className="row wrap">
          {link.is_own && link.state === 'open' && (
            <Button icon="copy" aria-busy={address.isPending} onClick={() => address.mutate()}>
              Show address
            </Button>
          )}
          {link.state !== 'revoked' && (
            <Button icon="cross" aria-busy={revoke.isPending} onClick={() => revoke.mutate()}>
              Revoke <span className="visually-hidden">{link.title}</span>
            </Button>
          )}
        </span>
      </div>
      <p className="small dim">
        {termsOf(link)}. Made by {link.made_by.name} {ago(link.created_at)}.
      </p>
      <Refusal error={address.error ?? revoke.error} />
      {address.data && <CopyAddress url={address.data} title={link.title} />}
      <div id={panelId} hidden={!opened}>
        {opened && <Opened projectId={projectId} link={link} />}
      </div>
    </Row>
  )
}

function Opened({ projectId, link }: { projectId: string; link: GuestLink }) {
  const visits = useInfiniteQuery(visitsQuery(link.id))
  const change = useChangeLink(projectId, link.id)
  const until = link.expires_at === null ? '' : dayAfter(new Date(link.expires_at), 0)
  return (
    <div className={`grid gap-2 ${classes.visits}`}>
      {link.state !== 'revoked' && (
        <div className="grid items-end gap-3 grid-cols-fill-180px">
          <TextInput
            label="Opens until"
            type="date"
            defaultValue={until}
            onBlur={(event) => {
              const { value } = event.currentTarget
              if (value !== until) change.mutate({ expires_at: value === '' ? null : endOfDay(value) })
            }}
          />
        </div>
      )}
      <Refusal error={change.error} />
      <h3 className="small">Heard by</h3>
      {visits.data?.length === 0 && <p className="small mid">Nobody has opened it yet.</p>}
      <ul>
        {visits.data?.map((visit) => (
          <li key={visit.id} className="small">
            <span className="strong">{visit.guest_name}</span> <span className="dim">{ago(visit.opened_at)}</span>
            {': '}
            {visit.played.length === 0
              ? 'nothing played'
              : visit.played
                  .map(({ cue_name, plays }) => `${cue_name} ${plays === 1 ? 'once' : `${plays} times`}`)
                  .join(', ')}
          </li>
        ))}
      </ul>
      {visits.hasNextPage && <Button onClick={() => void visits.fetchNextPage()}>Show more</Button>}
    </div>
  )
}
