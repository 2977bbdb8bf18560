import { useQuery } from '@tanstack/react-query'

import { ReferenceStrip } from '@/references'
import { Button } from '@/ui/Button'
import { VoiceLineWhereAny } from '@/voice-lines/VoiceLineWhereAny'

import { type Cue, cueQuery, type Rights } from '../api'
import type { FactQuestion } from '../clarity'
import { CutCue } from '../cue/CutCue'
import { EditCue } from '../cue/EditCue'
import classes from '../cue/Panel.module.css'
import { AskForm, QuestionLine } from '../cue/Questions'
import { SpokenPlaceholder } from '../spoken/SpokenPlaceholder'
import { ClarifyPanel } from './ClarifyPanel'

export type PanelKind = 'edit' | 'ask' | 'cut' | 'clarify' | 'say'

interface CuePanelProps {
  kind: PanelKind
  cue: Cue
  projectId: string
  categories: readonly string[]
  rights: Rights
  /** What its words leave open. */
  unclear: readonly FactQuestion[]
  onKind: (kind: PanelKind) => void
  onClose: () => void
}

/** What opens in place below a row: its facts, its questions, or the reason of a cut. */
export function CuePanel({ kind, cue, projectId, categories, rights, unclear, onKind, onClose }: CuePanelProps) {
  if (kind === 'cut') return <CutCue cue={cue} projectId={projectId} onClose={onClose} />
  if (kind === 'clarify') return <ClarifyPanel cue={cue} projectId={projectId} questions={unclear} onClose={onClose} />
  if (kind === 'ask') return <AskPanel cue={cue} projectId={projectId} mayAnswer={rights.edits} onClose={onClose} />
  if (kind === 'say') return <SayPanel cue={cue} projectId={projectId} mayEdit={rights.edits} onClose={onClose} />
  return (
    <EditCue
      cue={cue}
      projectId={projectId}
      categories={categories}
      onClose={onClose}
      more={
        rights.cuts && (
          <Button icon="struckRing" onClick={() => onKind('cut')}>
            Cut cue
          </Button>
        )
      }
    />
  )
}

interface SayPanelProps {
  cue: Cue
  projectId: string
  mayEdit: boolean
  onClose: () => void
}

function SayPanel({ cue, projectId, mayEdit, onClose }: SayPanelProps) {
  return (
    <div className={`grid gap-3 narrow-p-3 ${classes.panel}`}>
      <SpokenPlaceholder cueId={cue.id} cueName={cue.name} projectId={projectId} mayEdit={mayEdit} />
      <div className="row wrap">
        <Button className="end" keys="Escape" onClick={onClose}>
          Close
        </Button>
      </div>
    </div>
  )
}

interface AskPanelProps {
  cue: Cue
  projectId: string
  mayAnswer: boolean
  onClose: () => void
}

function AskPanel({ cue, projectId, mayAnswer, onClose }: AskPanelProps) {
  const { data, isPending } = useQuery(cueQuery(cue.id))
  const open = data?.questions.filter(({ answer }) => answer === null) ?? []
  const answers = mayAnswer && open.length > 0
  return (
    <section className={`grid gap-3 narrow-p-3 ${classes.panel}`} aria-label={`Questions on ${cue.name}`}>
      {open.map((question, at) => (
        <QuestionLine
          key={question.id}
          question={question}
          projectId={projectId}
          mayAnswer={mayAnswer}
          opens={at === 0}
        />
      ))}
      <VoiceLineWhereAny projectId={projectId} cueId={cue.id} />
      <ReferenceStrip projectId={projectId} cueId={cue.id} mayAdd={mayAnswer} />
      <AskForm cue={cue} projectId={projectId} opens={!isPending && !answers} onAsked={onClose} />
      <div className="row wrap">
        <Button className="end" keys="Escape" onClick={onClose}>
          Close
        </Button>
      </div>
    </section>
  )
}
