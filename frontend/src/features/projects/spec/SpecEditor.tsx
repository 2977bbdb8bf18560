import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { shortDay } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'

import { cuesQuery, type Project, type Spec } from '../api'
import { Writing } from './fields'
import { MovedOn } from './MovedOn'
import { SaveCard } from './SaveCard'
import classes from './SpecEditor.module.css'
import { SpecForm } from './SpecForm'
import { put } from './tables'
import { TomlEditor } from './TomlEditor'
import { useSpecDraft } from './useSpecDraft'

const NO_CUES: never[] = []

export function SpecEditor({ project, spec }: { project: Project; spec: Spec }) {
  const { id: projectId } = project
  const { data: cues = NO_CUES } = useQuery(cuesQuery(projectId))
  const writing = useSpecDraft(projectId, spec)
  const { draft, change, changeTables, switchTo, maySwitch, changed, movedOn, trouble, mine, theirs, drop, send } =
    writing
  useHotkeys([{ keys: 'mod+s', label: 'Save spec', group: 'Delivery spec', run: send }])

  return (
    <>
      <div className={classes.head}>
        <div>
          <h1>Delivery spec</h1>
          <p className="mid">
            {`Version ${draft.basedOn}${movedOn ? '' : `, ${shortDay(spec.created_at)}`} of `}
            <Link className="link" to="/projects/$projectId" params={{ projectId }}>
              {project.name}
            </Link>
          </p>
        </div>
        <div className="row wrap">
          <Link className="link" to="/projects/$projectId/spec/versions" params={{ projectId }} search={{}}>
            Versions
          </Link>
          <Segmented
            label="Edit as"
            options={[
              { value: 'form', label: 'Form' },
              { value: 'toml', label: 'TOML' },
            ]}
            value={draft.mode}
            onChange={(mode) => maySwitch && switchTo(mode)}
          />
        </div>
      </div>
      {writing.wasRestored && (
        <p className={`row wrap ${classes.note}`}>
          Your unsaved changes were restored.
          <Button variant="quiet" onClick={drop}>
            Discard
          </Button>
        </p>
      )}
      {movedOn && changed && (
        <MovedOn
          spec={spec}
          theirs={theirs}
          mine={mine}
          basedOn={draft.basedOn}
          onKeepMine={() => change({ basedOn: spec.version })}
          onTakeTheirs={drop}
        />
      )}
      <div className={`columns ${classes.columns}`}>
        {draft.mode === 'form' ? (
          <Writing
            value={{
              tables: draft.tables,
              set: (place, value) => changeTables((tables) => put(tables, place, value)),
              change: changeTables,
              trouble,
            }}
          >
            <SpecForm cues={cues} />
          </Writing>
        ) : (
          <Card aria-labelledby="as-toml">
            <CardHead id="as-toml" title="spec.toml" note="the file audio-checks reads" />
            <TomlEditor toml={draft.toml} onChange={(toml) => change({ toml })} trouble={trouble} />
          </Card>
        )}
        <SaveCard spec={spec} writing={writing} />
      </div>
    </>
  )
}
