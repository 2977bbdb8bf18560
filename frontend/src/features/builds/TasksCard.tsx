import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ago, plural } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'

import { type GameTask, useChangeTask, useTasks } from './api'
import classes from './Drift.module.css'
import { timeOf } from './moments'
import { ROLE_WORDS, signed, TASK_WORDS } from './words'

interface TasksCardProps {
  projectId: string
  /** How many are shown before the rest is a number; without it, all, with those that are done. */
  most?: number
}

/** What is to be done so that the game plays its sounds as it should. */
export function TasksCard({ projectId, most }: TasksCardProps) {
  const [shown, setShown] = useState<'open' | 'done'>('open')
  const { data: tasks, error } = useTasks(projectId, shown === 'done')
  const change = useChangeTask(projectId)
  const refused = change.error ?? error
  return (
    <Card aria-labelledby="tasks" aria-busy={tasks === undefined}>
      <CardHead
        id="tasks"
        title="Tasks"
        count={shown === 'open' ? tasks?.length : undefined}
        end={
          most === undefined ? (
            <Segmented
              label="Shown"
              value={shown}
              onChange={setShown}
              options={[
                { value: 'open', label: 'To do' },
                { value: 'done', label: 'Done' },
              ]}
            />
          ) : (
            <Link className="link" to="/projects/$projectId/game-tasks" params={{ projectId }}>
              All<span className="visually-hidden"> tasks</span>
            </Link>
          )
        }
      />
      <Refusal error={refused} />
      {tasks?.length === 0 && (
        <div className="grid gap-2 p-3-inset">
          <EmptyState head={shown === 'open' ? 'Nothing to do' : 'Nothing is done yet'} level={3}>
            Notes of a listening pass and drift that is sent back become tasks: levels and missing sounds for the
            implementers, lengths and wrong sounds for the designer.
          </EmptyState>
        </div>
      )}
      <ul>
        {tasks?.slice(0, most).map((task) => (
          <TaskRow
            key={task.id}
            task={task}
            projectId={projectId}
            onChange={(isDone) => change.mutate({ id: task.id, isDone })}
          />
        ))}
      </ul>
      {most !== undefined && tasks && tasks.length > most && (
        <p className="small mid p-2-inset-3">{`and ${plural(tasks.length - most, 'task')} more`}</p>
      )}
    </Card>
  )
}

interface TaskRowProps {
  task: GameTask
  projectId: string
  onChange: (isDone: boolean) => void
}

function TaskRow({ task, projectId, onChange }: TaskRowProps) {
  const name = task.cue?.name ?? task.path
  const isDone = task.done_at !== null
  const gain = task.gain_db === null ? '' : `, ${signed(task.gain_db)}`
  return (
    <li className={`grid items-center gap-3 border-t wrap-anywhere grid-cols-1-auto ${classes.task}`}>
      <div>
        <p>
          <span className="strong">{name}</span> {`${TASK_WORDS[task.kind].toLowerCase()}${gain}`}
        </p>
        {task.where !== '' && <p className="small mono">{task.where}</p>}
        {task.text !== '' && <p className="small">{task.text}</p>}
        {task.recording && (
          <p className="small">
            <Link
              className="link"
              to="/projects/$projectId/recording"
              params={{ projectId }}
              search={{ recording: task.recording.reference_version_id, at: task.recording.at_s }}
            >
              {`Hear it at ${timeOf(task.recording.at_s)} of the recording`}
            </Link>
          </p>
        )}
        <p className="small dim">{`${ROLE_WORDS[task.role]}, from ${task.asked_by.name}, ${ago(task.asked_at)}`}</p>
      </div>
      {task.may_do && (
        <Button aria-label={`${isDone ? 'Open again' : 'Done'}: ${name}`} onClick={() => onChange(!isDone)}>
          {isDone ? 'Open again' : 'Done'}
        </Button>
      )}
    </li>
  )
}
