import { Checkbox, Textarea } from '@mantine/core'
import { Link } from '@tanstack/react-router'

import { Dialog } from '@/app/Dialog'
import { DraftForm } from '@/app/drafts/DraftForm'
import { sentence } from '@/ui/sentence'
import { showToast } from '@/app/toast'
import { Field, Submit } from '@/ui/Form'
import { length } from '@/ui/format'
import { languageName, LineState, percentOf, type VoiceLine } from '@/voice-lines'

import { useChangeLine, useChangeText } from './api'
import classes from './VoiceLines.module.css'

interface LineDialogProps {
  projectId: string
  line: VoiceLine | null
  mayChange: boolean
  onClose: () => void
}

/** One line with what is said around it, its take, and its text to change. */
export function LineDialog({ projectId, line, mayChange, onClose }: LineDialogProps) {
  return (
    <Dialog
      title={line ? `${line.character.name}, ${line.key}` : ''}
      opened={line !== null}
      onClose={onClose}
      size={640}
    >
      {line && (
        <div className={classes.detail}>
          <p className="flex wrap items-center gap-2-3">
            <LineState state={line.state} />
            <span className="small dim">
              {languageName(line.language)}
              {line.performer && `, spoken by ${line.performer}`}
              {line.directed_by && `, directed by ${line.directed_by}`}
            </span>
            {line.cue && (
              <Link
                className="link small end"
                to="/projects/$projectId/sound-list/cues/$cueId"
                params={{ projectId, cueId: line.cue.id }}
              >
                {line.cue.label} {line.cue.name}
              </Link>
            )}
          </p>
          {line.reason && <p className="small tone-warn toned">{sentence(line.reason)}</p>}
          <div className={`pre-line ${classes.context}`}>
            {line.before && (
              <p className="small dim">
                {line.before.character}: {line.before.text}
              </p>
            )}
            <p lang={line.language}>{line.text ?? 'Not translated yet'}</p>
            {line.original_text !== null && line.original_text !== line.text && (
              <p className="small mid">Original: {line.original_text}</p>
            )}
            {line.after && (
              <p className="small dim">
                {line.after.character}: {line.after.text}
              </p>
            )}
          </div>
          <Length line={line} />
          {mayChange && <EditLine key={line.text_version} projectId={projectId} line={line} onDone={onClose} />}
        </div>
      )}
    </Dialog>
  )
}

function Length({
  line: { take, original_duration_s: original, length_percent: percent, length_is_off },
}: {
  line: VoiceLine
}) {
  if (!take || take.duration_s === null) return null
  return (
    <p className={`small ${length_is_off ? 'tone-warn toned' : 'mid'}`}>
      Version {take.number}: {length(take.duration_s)}
      {percent !== null && original !== null && `, ${percentOf(percent)} against the original's ${length(original)}`}
    </p>
  )
}

function EditLine({ projectId, line, onDone }: { projectId: string; line: VoiceLine; onDone: () => void }) {
  const changeText = useChangeText(projectId, line.id, line.language)
  const changeLine = useChangeLine(projectId, line.id)
  const save = async (typed: { text: string; scene: string; direction: string; takesFit: boolean }) => {
    if (typed.scene !== line.scene || typed.direction !== line.direction)
      await changeLine.mutateAsync({ scene: typed.scene, direction: typed.direction })
    if (line.text_version !== null && (typed.text !== line.text || typed.takesFit))
      await changeText.mutateAsync({ text: typed.text, text_version: line.text_version, takes_fit: typed.takesFit })
  }
  return (
    <DraftForm
      draftKey={`voice-line:${line.id}:${line.language}:${line.text_version ?? 0}`}
      className={classes.form}
      initialValues={{ text: line.text ?? '', scene: line.scene, direction: line.direction, takesFit: false }}
      mutation={{
        isPending: changeText.isPending || changeLine.isPending,
        error: changeText.error ?? changeLine.error,
      }}
      onSubmit={(typed, onSent) =>
        void save(typed).then(
          () => {
            onSent()
            showToast('Line saved.')
            onDone()
          },
          () => undefined, // the refusal is shown
        )
      }
    >
      {line.text_version !== null && (
        <>
          <Field as={Textarea} optional name="text" label="Text" rows={3} maxLength={5000} data-autofocus />
          {line.take && <Field as={Checkbox} name="takesFit" label="Takes that exist still fit this text" />}
        </>
      )}
      <Field optional name="direction" label="Direction" maxLength={2000} />
      <Field optional name="scene" label="Scene" maxLength={200} />
      <Submit>Save</Submit>
    </DraftForm>
  )
}
