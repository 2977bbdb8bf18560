import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { useMyProject } from '@/api/me'
import { playlistsQuery } from '@/api/project'
import { keptCuesQuery } from '@/api/soundList'
import { DraftForm } from '@/app/drafts/DraftForm'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { ago, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { linksQuery, useAddPlaylist } from './api'
import { chosenCues, NO_FILTER } from './choice'
import { CueChoice } from './CueChoice'
import { LinkForm } from './LinkForm'
import { LinkRow } from './LinkRow'
import classes from './Shares.module.css'

/** Links for people without an account, and playlists for those with one. */
export function SharingPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { cue, playlist } = useSearch({ from: '/shell/projects/$projectId/sharing' })
  const project = useMyProject(projectId)
  const mayShare = (project?.is_producer || project?.is_liaison || project?.is_approver) ?? false
  const isAsked = cue !== undefined || playlist !== undefined // another page asked for a link
  const [form, setForm] = useState<'link' | 'playlist' | null>(isAsked ? 'link' : null)
  const toggle = (kind: 'link' | 'playlist') => setForm(form === kind ? null : kind)
  useTitle('Sharing')
  return (
    <div className={`page stack content-start ${classes.page}`}>
      <header className="row wrap">
        <h1>Sharing</h1>
        {mayShare && (
          <div className="row wrap">
            <Button icon="plus" aria-expanded={form === 'link'} onClick={() => toggle('link')}>
              New guest link
            </Button>
            <Button icon="plus" aria-expanded={form === 'playlist'} onClick={() => toggle('playlist')}>
              New playlist
            </Button>
          </div>
        )}
      </header>
      <div className={`grid items-start gap-4 ${classes.two}`}>
        <div className={classes.stack}>
          {mayShare && form === 'link' && (
            <LinkForm key={`${cue} ${playlist}`} projectId={projectId} cueId={cue} playlistId={playlist} />
          )}
          {mayShare && <Links projectId={projectId} />}
        </div>
        <div className={classes.stack}>
          {mayShare && form === 'playlist' && <NewPlaylist projectId={projectId} />}
          <Playlists projectId={projectId} />
        </div>
      </div>
    </div>
  )
}

function Links({ projectId }: { projectId: string }) {
  const links = useInfiniteQuery(linksQuery(projectId))
  return (
    <Card aria-labelledby="links" aria-busy={links.isPending}>
      <CardHead id="links" title="Guest links" count={links.data?.length} />
      <Refusal error={links.error} />
      {links.data?.length === 0 && (
        <p className="mid grid gap-3 p-3-inset-4">
          No links yet. A link lets a publisher, a composer or a friend hear sounds without an account.
        </p>
      )}
      <Rows aria-label="Guest links">
        {links.data?.map((link) => (
          <LinkRow key={link.id} projectId={projectId} link={link} />
        ))}
      </Rows>
      {links.hasNextPage && <Button onClick={() => void links.fetchNextPage()}>Show more</Button>}
    </Card>
  )
}

function Playlists({ projectId }: { projectId: string }) {
  const { data: playlists, error } = useQuery(playlistsQuery(projectId))
  return (
    <Card aria-labelledby="playlists">
      <CardHead id="playlists" title="Playlists" count={playlists?.length} />
      <Refusal error={error} />
      {playlists?.length === 0 && (
        <p className="mid grid gap-3 p-3-inset-4">
          No playlists yet. A playlist plays sounds one after another, alone or together with others of the team.
        </p>
      )}
      <Rows aria-label="Playlists">
        {playlists?.map(({ id, name, takes, made_by, created_at }) => (
          <Row key={id}>
            <Link
              to="/projects/$projectId/playlists/$playlistId"
              params={{ projectId, playlistId: id }}
              className="link cut-text"
            >
              {name}
            </Link>
            <span className="small dim end nowrap">
              {plural(takes, 'sound')}, {made_by.name} {ago(created_at)}
            </span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

function NewPlaylist({ projectId }: { projectId: string }) {
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const add = useAddPlaylist(projectId)
  const navigate = useNavigate()
  return (
    <Card aria-labelledby="new-playlist">
      <CardHead id="new-playlist" title="New playlist" />
      <DraftForm
        draftKey={`playlist:${projectId}`}
        className={classes.form}
        initialValues={{ name: '', filter: NO_FILTER }}
        mutation={add}
        onSubmit={({ name, filter }, onSent) =>
          add.mutate(
            {
              name: name.trim() || filter.category || 'Playlist',
              cue_ids: chosenCues(cues ?? [], filter)
                .map(({ id }) => id)
                .slice(0, 500),
            },
            {
              onSuccess: ({ id: playlistId }) => {
                onSent()
                void navigate({ to: '/projects/$projectId/playlists/$playlistId', params: { projectId, playlistId } })
              },
            },
          )
        }
      >
        {({ filter }) => (
          <>
            <Field optional name="name" label="Name" maxLength={200} placeholder={filter.category || 'Playlist'} />
            <Field as={CueChoice} name="filter" projectId={projectId} />
            <Submit variant="plain">Make playlist</Submit>
          </>
        )}
      </DraftForm>
    </Card>
  )
}
