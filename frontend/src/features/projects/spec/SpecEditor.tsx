import { useQuery } from '@tanstack/react-query'
import { cuesQuery } from '@/api/soundList'
import { Link, useNavigate, useSearch } from '@tanstack/react-router'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { shortDay } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Segmented } from '@/ui/Segmented'

import { type Project, type Spec } from '../api'
import { Writing } from './fields'
import { SpecConflict } from './SpecConflict'
import { SaveCard } from './SaveCard'
import { SentencesView } from './SentencesView'
import classes from './SpecEditor.module.css'
import { SpecForm } from './SpecForm'
import { put } from './tables'
import { TomlEditor } from './TomlEditor'
import { useSpecDraft } from './useSpecDraft'

const NO_CUES: never[] = []

export function SpecEditor({ project, spec }: { project: Project; spec: Spec }) {
  const { id: projectId } = project
  const { data: cues = NO_CUES } = useQuery(cuesQuery(projectId))
  const asked = useSearch({ from: '/shell/projects/$projectId/spec' }).view
  const navigate = useNavigate()
  const writing = useSpecDraft(projectId, spec)
  const { draft, change, changeTables, switchTo, maySwitch, changed, movedOn, trouble, mine, theirs, drop, send } =
    writing
  // What is written as TOML has no tables to make sentences of until it is read as a form again.
  const view = asked === 'all' || draft.mode === 'toml' ? 'all' : 'sentences'
  useHotkeys([{ keys: 'mod+s', label: 'Save spec', group: 'Delivery spec', run: () => send(view === 'sentences') }])

  return (
    <>
      <div className="mb-4">
        <PageHead
          title="Delivery spec"
          actions={
            <>
              <Link className="link" to="/projects/$projectId/spec/versions" params={{ projectId }} search={{}}>
                Versions
              </Link>
              {view === 'all' && (
                <Segmented
                  label="Edit as"
                  options={[
                    { value: 'form', label: 'Form' },
                    { value: 'toml', label: 'TOML' },
                  ]}
                  value={draft.mode}
                  onChange={(mode) => maySwitch && switchTo(mode)}
                />
              )}
              <Button
                onClick={() => {
                  if (view === 'all' && maySwitch) switchTo('form')
                  void navigate({ to: '.', search: view === 'all' ? {} : { view: 'all' } })
                }}
              >
                {view === 'all' ? 'In sentences' : 'All settings'}
              </Button>
            </>
          }
        >
          {`What a delivered sound must be. Version ${draft.basedOn}${movedOn ? '' : `, ${shortDay(spec.created_at)}`}.`}
        </PageHead>
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
        <SpecConflict
          spec={spec}
          theirs={theirs}
          mine={mine}
          basedOn={draft.basedOn}
          onKeepMine={() => change({ basedOn: spec.version })}
          onTakeTheirs={drop}
        />
      )}
      <Writing
        value={{
          tables: draft.tables,
          set: (place, value) => changeTables((tables) => put(tables, place, value)),
          change: changeTables,
          trouble,
        }}
      >
        {view === 'sentences' ? (
          <SentencesView
            projectId={projectId}
            cues={cues}
            read={writing.result ?? spec}
            basedOn={spec.version}
            isChanged={changed}
          >
            {changed ? <SaveCard spec={spec} writing={writing} stays /> : <WhenSaved version={spec.version + 1} />}
          </SentencesView>
        ) : (
          <div className={`columns ${classes.columns}`}>
            {draft.mode === 'form' ? (
              <SpecForm cues={cues} />
            ) : (
              <Card aria-labelledby="as-toml">
                <CardHead id="as-toml" title="spec.toml" note="the file audio-checks reads" />
                <TomlEditor toml={draft.toml} onChange={(toml) => change({ toml })} trouble={trouble} />
              </Card>
            )}
            <SaveCard spec={spec} writing={writing} />
          </div>
        )}
      </Writing>
    </>
  )
}

const WhenSaved = ({ version }: { version: number }) => (
  <Card aria-labelledby="when-saved">
    <CardHead id="when-saved" title="When you save" />
    <p className="small mid grid gap-3 p-inset">
      {`Version ${version} begins. Versions in review are checked again; approved sounds stay approved. The designers see what changed.`}
    </p>
  </Card>
)
