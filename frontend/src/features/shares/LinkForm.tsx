import { Checkbox, NativeSelect, PasswordInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { playlistsQuery } from '@/api/project'
import { keptCuesQuery } from '@/api/soundList'
import { DraftForm } from '@/app/drafts/DraftForm'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Segmented } from '@/ui/Segmented'

import { type GuestLinkAdd, useAddLink } from './api'
import { chosenCues, NO_FILTER } from './choice'
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

const kindFor = (playlistId?: string): GuestLinkAdd['kind'] => (playlistId === undefined ? 'cues' : 'playlist')

/** A link for people without an account: what they hear, until when, and whether they may comment. */
export function LinkForm({ projectId, cueId, playlistId }: { projectId: string; cueId?: string; playlistId?: string }) {
  const [password, setPassword] = useState('')
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const { data: playlists } = useQuery(playlistsQuery(projectId))
  const add = useAddLink(projectId)
  const [initialValues] = useState(() => ({
    shared: kindFor(playlistId),
    filter: { ...NO_FILTER, cueId: cueId ?? '' },
    playlist_id: playlistId ?? '',
    title: '',
    expires_at: dayAfter(new Date(), DAYS_OPEN),
    max_openings: '',
    may_comment: true,
    has_beeps: false,
  }))
  const suggestedTitle = ({ shared, filter, playlist_id }: typeof initialValues) => {
    if (shared === 'playlist') return playlists?.find(({ id }) => id === playlist_id)?.name ?? ''
    if (shared !== 'cues') return TITLES[shared]
    const [first, second] = chosenCues(cues ?? [], filter)
    return first && !second ? first.name : filter.category || 'Sounds'
  }
  return (
    <Card aria-labelledby="new-link">
      <CardHead id="new-link" title="New guest link" />
      <DraftForm
        draftKey={`guest-link:${projectId}:${cueId ?? ''}${playlistId ?? ''}`}
        className={classes.form}
        initialValues={initialValues}
        mutation={add}
        onSubmit={(typed, onSent) =>
          add.mutate(
            {
              kind: typed.shared,
              title: typed.title.trim() || suggestedTitle(typed) || 'Sounds',
              cue_ids: typed.shared === 'cues' ? chosenCues(cues ?? [], typed.filter).map(({ id }) => id) : [],
              playlist_id: typed.shared === 'playlist' ? typed.playlist_id : null,
              password: password || null,
              expires_at: typed.expires_at === '' ? null : endOfDay(typed.expires_at),
              max_openings: typed.max_openings === '' ? null : Number(typed.max_openings),
              may_comment: typed.may_comment,
              has_beeps: typed.has_beeps,
            },
            {
              onSuccess: () => {
                onSent()
                setPassword('')
              },
            },
          )
        }
      >
        {(typed, change) => (
          <>
            <Segmented
              label="What guests hear"
              options={KINDS}
              value={typed.shared}
              onChange={(shared) => change({ shared })}
            />
            {typed.shared === 'cues' && <Field as={CueChoice} name="filter" projectId={projectId} />}
            {typed.shared === 'playlist' && (
              <Field
                as={NativeSelect}
                name="playlist_id"
                label="Playlist"
                data={[
                  { value: '', label: 'Choose one' },
                  ...(playlists ?? []).map(({ id, name }) => ({ value: id, label: name })),
                ]}
              />
            )}
            <div className="grid items-end gap-3 grid-cols-fill-180px">
              <Field
                optional
                name="title"
                label="Title for guests"
                placeholder={suggestedTitle(typed)}
                maxLength={200}
              />
              <PasswordInput
                label="Password (optional)"
                autoComplete="new-password"
                maxLength={200}
                value={password}
                onChange={(event) => setPassword(event.currentTarget.value)}
                visibilityToggleButtonProps={{ 'aria-label': 'Show password' }}
              />
              <Field optional name="expires_at" label="Opens until" type="date" />
              <Field
                optional
                name="max_openings"
                label="Max. opens (optional)"
                inputMode="numeric"
                maxLength={6}
                onValue={(most) => change({ max_openings: most.replace(/\D/g, '') })}
              />
            </div>
            <Field as={Checkbox} name="may_comment" label="Guests may comment, under a name they type" />
            <Field as={Checkbox} name="has_beeps" label="Mix in a quiet beep every four seconds" />
            <Submit>Make link</Submit>
          </>
        )}
      </DraftForm>
      {add.data && (
        <div className={classes.form}>
          <CopyAddress url={add.data.url} title={add.data.link.title} />
        </div>
      )}
    </Card>
  )
}
