import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { playlistsQuery } from '@/api/project'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

/** The playlists in which a designer's sounds are; nothing where the team made none with them. */
export function PlaylistsCard({ projectId }: { projectId: string }) {
  const { data: playlists, error } = useQuery(playlistsQuery(projectId))
  if (!error && !playlists?.length) return null
  return (
    <Card aria-labelledby="playlists">
      <CardHead id="playlists" title="Playlists with your sounds" count={playlists?.length} />
      <Refusal inset error={error} />
      <Rows aria-label="Playlists with your sounds">
        {playlists?.map(({ id, name, takes, made_by }) => (
          <Row key={id}>
            <Link
              to="/projects/$projectId/playlists/$playlistId"
              params={{ projectId, playlistId: id }}
              className="link cut-text"
            >
              {name}
            </Link>
            <span className="small dim end nowrap">
              {plural(takes, 'sound')}, by {made_by.name}
            </span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}
