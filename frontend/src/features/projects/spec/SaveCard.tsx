import { Textarea } from '@mantine/core'

import { ApiProblem } from '@/api'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'
import { sentence } from '@/ui/sentence'

import type { Spec } from '../api'
import { goTo, goToLine } from './goTo'
import { LineDiff } from './LineDiff'
import { correctionOf, lineOf } from './places'
import classes from './SpecEditor.module.css'
import { troubleOf } from './trouble'
import type { SpecWriting } from './useSpecDraft'

/** Whether the spec is valid, what is wrong with it and where, and the button that saves it. */
export function SaveCard({ spec, writing, stays = false }: { spec: Spec; writing: SpecWriting; stays?: boolean }) {
  const { draft, change, changed, movedOn, isCurrent, trouble, result, mine, theirs, save, drop, send } = writing
  const otherMode = draft.mode === 'form' ? 'TOML' : 'form'
  const isMovedOn = save.error instanceof ApiProblem && save.error.code === 'spec-changed'
  const correction = trouble && draft.mode === 'toml' ? correctionOf(draft.toml, trouble.place, trouble.message) : null
  const line = trouble && draft.mode === 'toml' ? lineOf(draft.toml, trouble.place, trouble.message) : null
  return (
    <Card className={classes.save} aria-labelledby="save">
      <CardHead id="save" title="Save" end={changed ? undefined : 'no changes'} />
      <div className="grid gap-3 p-inset">
        <div aria-live="polite" className={`grid gap-2 ${classes.stands}`}>
          {changed && !isCurrent && trouble === null && <p className="mid">Validating…</p>}
          {trouble && (
            <div className={`tone-bad flex gap-2 wrap-anywhere ${classes.trouble}`} id="spec-trouble">
              <Icon name="back" />
              <div>
                {trouble.place !== '' && <p className="mono strong toned">{trouble.place}</p>}
                <p>{sentence(trouble.message)}</p>
                <p className="row wrap">
                  {line !== null && (
                    <button type="button" className="link small" onClick={() => goToLine(draft.toml, line)}>
                      {`Line ${line}`}
                    </button>
                  )}
                  {draft.mode === 'form' && trouble.place !== '' && (
                    <button type="button" className="link small" onClick={() => goTo(trouble.place)}>
                      Go to line
                    </button>
                  )}
                  {correction && (
                    <button type="button" className="link" onClick={() => change({ toml: correction.toml })}>
                      {correction.label}
                    </button>
                  )}
                </p>
              </div>
            </div>
          )}
          {result && trouble === null && changed && (
            <p className={`row tone-ok ${classes.sign}`}>
              <Icon name="tick" />
              The spec is valid.
            </p>
          )}
          {result?.warnings.map((warning) => (
            <p key={warning} className={`row top tone-warn ${classes.sign}`}>
              <Icon name="triangle" />
              <span>{sentence(warning)}</span>
            </p>
          ))}
          {!writing.maySwitch && trouble && <p className="small dim">{`Fix the error to switch to ${otherMode}.`}</p>}
        </div>
        {draft.mode === 'form' && writing.losesComments && (
          <p className="small mid">The form rewrites the TOML without comments. Edit the TOML to keep them.</p>
        )}
        <Textarea
          label="Version note: what changed and why"
          rows={2}
          resize="vertical"
          value={draft.note}
          onChange={({ currentTarget }) => change({ note: currentTarget.value })}
        />
        {!isMovedOn && troubleOf(save.error) === null && <Refusal inset error={save.error} />}
        <div className="row wrap">
          <Button
            variant="primary"
            keys="mod+s"
            disabled={!changed || movedOn || save.isPending}
            aria-busy={save.isPending}
            onClick={() => send(stays)}
          >
            {`Save version ${spec.version + 1}`}
          </Button>
          {changed && (
            <Button variant="quiet" onClick={drop}>
              Discard changes
            </Button>
          )}
        </div>
        {changed && movedOn && <p className="small mid">Choose above which text to keep.</p>}
        <p className="small dim">Affected versions in review are rechecked. Approved versions stay approved.</p>
      </div>
      {changed && result && theirs !== undefined && (
        <details className={`border-t ${classes.diff}`}>
          <summary>Changes</summary>
          <LineDiff before={theirs} after={mine} label="Changes" />
        </details>
      )}
    </Card>
  )
}
