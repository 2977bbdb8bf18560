import { Checkbox, PasswordInput, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import { playlistsQuery } from '@/api/project'
import { keptCuesQuery } from '@/api/soundList'
import { DraftNote, useDraft } from '@/app/drafts'
import { sentence } from '@/ui/sentence'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'

import { type GuestLinkAdd, useAddLink } from './api'
import { chosenCues, type CueFilter, NO_FILTER } from './choice'
import { CopyAddress } from './CopyAddress'
import { CueChoice } from './CueChoice'
import { dayAfter, endOfDay } from './days'
import classes from './Shares.module.css'

const DAYS_OPEN = 14

const KINDS: { value: GuestLinkAdd['kind']; label: string }[] = [
  { value: 'cues', label: 'Cues' },
  { value: 'palette', label: 'Palette' },
  { value: 'approved', label: 'All approved' },
  { value: 'playlist', label: 'Playlist' },
]
const TITLES: Record<GuestLinkAdd['kind'], string> = {
  cues: '',
  palette: 'Palette',
  approved: 'Approved sounds',
  playlist: '',
}

interface Typed {
  kind: GuestLinkAdd['kind']
  filter: CueFilter
  playlistId: string
  title: string
  expires: string
  most: string
  mayComment: boolean
  hasBeeps: boolean
}

/** A link for people without an account: what they hear, until when, and whether they may comment. */
export function LinkForm({ projectId, cueId, playlistId }: { projectId: string; cueId?: string; playlistId?: string }) {
  const [typed, setTyped, draft] = useDraft<Typed>(`guest-link:${projectId}:${cueId ?? ''}${playlistId ?? ''}`, () => ({
    kind: playlistId === undefined ? 'cues' : 'playlist',
    filter: { ...NO_FILTER, cueId: cueId ?? '' },
    playlistId: playlistId ?? '',
    title: '',
    expires: dayAfter(new Date(), DAYS_OPEN),
    most: '',
    mayComment: true,
    hasBeeps: false,
  }))
  const [password, setPassword] = useState('')
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const { data: playlists } = useQuery(playlistsQuery(projectId))
  const add = useAddLink(projectId)
  const refusal = add.error instanceof ApiProblem ? add.error : null
  const against = (name: string) => {
    const message = refusal?.of(name)?.message
    return message && sentence(message)
  }
  const playlist = playlists?.find(({ id }) => id === typed.playlistId)
  const chosen = chosenCues(cues ?? [], typed.filter)
  const suggested =
    typed.kind === 'playlist'
      ? (playlist?.name ?? '')
      : typed.kind === 'cues'
        ? chosen.length === 1
          ? (chosen[0]?.name ?? '')
          : typed.filter.category || 'Sounds'
        : TITLES[typed.kind]
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (add.isPending) return
    add.mutate(
      {
        kind: typed.kind,
        title: typed.title.trim() || suggested || 'Sounds',
        cue_ids: typed.kind === 'cues' ? chosen.map(({ id }) => id) : [],
        playlist_id: typed.kind === 'playlist' ? typed.playlistId || null : null,
        password: password || null,
        expires_at: typed.expires === '' ? null : endOfDay(typed.expires),
        max_openings: typed.most === '' ? null : Number(typed.most),
        may_comment: typed.mayComment,
        has_beeps: typed.hasBeeps,
      },
      {
        onSuccess: () => {
          draft.discard()
          setPassword('')
        },
      },
    )
  }
  return (
    <Card aria-labelledby="new-link">
      <CardHead id="new-link" title="New guest link" />
      <form className={classes.form} onSubmit={send} noValidate>
        <Segmented
          label="What guests hear"
          options={KINDS}
          value={typed.kind}
          onChange={(kind) => setTyped({ ...typed, kind })}
        />
        {typed.kind === 'cues' && (
          <CueChoice
            projectId={projectId}
            filter={typed.filter}
            onFilter={(filter) => setTyped({ ...typed, filter })}
            problem={against('cue_ids')}
          />
        )}
        {typed.kind === 'playlist' && (
          <Select
            label="Playlist"
            value={typed.playlistId}
            onChange={(event) => setTyped({ ...typed, playlistId: event.currentTarget.value })}
          >
            <option value="">Choose one</option>
            {playlists?.map(({ id, name }) => (
              <option key={id} value={id}>
                {name}
              </option>
            ))}
          </Select>
        )}
        {typed.kind === 'playlist' && against('playlist_id') && <ErrorBanner detail={against('playlist_id') ?? ''} />}
        <div className={`grid items-end gap-3 ${classes.fields}`}>
          <TextInput
            label="Title for guests"
            placeholder={suggested}
            maxLength={200}
            value={typed.title}
            onChange={(event) => setTyped({ ...typed, title: event.currentTarget.value })}
            error={against('title')}
          />
          <PasswordInput
            label="Password (optional)"
            autoComplete="new-password"
            maxLength={200}
            value={password}
            onChange={(event) => setPassword(event.currentTarget.value)}
            visibilityToggleButtonProps={{ 'aria-label': 'Show password' }}
            error={against('password')}
          />
          <TextInput
            label="Opens until"
            type="date"
            value={typed.expires}
            onChange={(event) => setTyped({ ...typed, expires: event.currentTarget.value })}
            error={against('expires_at')}
          />
          <TextInput
            label="Max. opens (optional)"
            inputMode="numeric"
            value={typed.most}
            onChange={(event) => setTyped({ ...typed, most: event.currentTarget.value.replace(/\D/g, '').slice(0, 6) })}
            error={against('max_openings')}
          />
        </div>
        <Checkbox
          label="Guests may comment, under a name they type"
          checked={typed.mayComment}
          onChange={(event) => setTyped({ ...typed, mayComment: event.currentTarget.checked })}
        />
        <Checkbox
          label="Mix in a quiet beep every four seconds"
          checked={typed.hasBeeps}
          onChange={(event) => setTyped({ ...typed, hasBeeps: event.currentTarget.checked })}
        />
        <DraftNote draft={draft} />
        {refusal && refusal.errors.length === 0 && (
          <ErrorBanner detail={sentence(refusal.detail)} fix={refusal.fix ? sentence(refusal.fix) : undefined} />
        )}
        <div className="row wrap">
          <Button type="submit" variant="primary" aria-busy={add.isPending}>
            Make link
          </Button>
        </div>
        {add.data && <CopyAddress url={add.data.url} title={add.data.link.title} />}
      </form>
    </Card>
  )
}
