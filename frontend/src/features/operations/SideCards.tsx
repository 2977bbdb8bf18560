import { useQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'
import { ago, bytes, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { operationsQuery, type Scope, type Storage } from './api'
import classes from './Operations.module.css'

const sizeOf = ({ master_bytes, render_bytes }: Storage) => master_bytes + render_bytes

/** What is kept: masters as they came, game files as they were made. */
export function StorageCard({ scope }: { scope: Scope }) {
  const { data } = useQuery(operationsQuery(scope))
  const storage = data?.storage ?? []
  const whole = storage.reduce((sum, one) => sum + sizeOf(one), 0)
  return (
    <Card aria-labelledby="storage">
      <CardHead id="storage" title="Storage" note={data ? `${bytes(whole)} of masters and game files` : undefined} />
      <Rows aria-labelledby="storage">
        {storage.map((one) => (
          <Row key={one.studio_id} className={classes.kept}>
            <span className="grow">
              <span className="strong">{one.studio_name}</span>
              <br />
              <span className="small dim">
                {plural(one.masters, 'master')} {bytes(one.master_bytes)}, {plural(one.renders, 'game file')}{' '}
                {bytes(one.render_bytes)}
              </span>
            </span>
            <span className="num">{bytes(sizeOf(one))}</span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

/** The processes that do the jobs: each for an operator, their number for a producer. */
export function WorkersCard({ scope }: { scope: Scope }) {
  const { data } = useQuery(operationsQuery(scope))
  if (data === undefined) return null
  return (
    <Card aria-labelledby="workers">
      <CardHead id="workers" title="Workers" count={data.alive} />
      {data.workers.length === 0 ? (
        <p className={`mid ${classes.inside}`}>
          {data.alive > 0
            ? 'They check, render and mail for every studio in turn.'
            : 'None has said within 20 seconds that it lives. Whoever runs the server starts one with: soundlist worker'}
        </p>
      ) : (
        <Rows aria-labelledby="workers">
          {data.workers.map(({ id, beat_at }) => (
            <Row key={id} dense>
              <span className={`grow ${classes.worker}`}>{id}</span>
              <span className="small dim">said so {ago(beat_at)}</span>
            </Row>
          ))}
        </Rows>
      )}
    </Card>
  )
}
