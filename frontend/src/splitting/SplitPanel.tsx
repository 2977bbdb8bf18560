import { NumberInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type ReactNode, useState } from 'react'

import { keptCuesQuery } from '@/api/soundList'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Field, Form, Submit } from '@/ui/Form'
import { place, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'
import { type Column, Table } from '@/ui/Table'

import { type Split, type SplitPart, useFindParts, useSplit, useUndoSplit, useUseSplit } from './api'

interface SplitPanelProps {
  projectId: string
  takeId: string
  fileName: string
  /** The cue that the file is for; null while it has none. */
  cueId: string | null
  /** Play the file from a position; undefined while it cannot be heard. */
  onHear?: (fromS: number) => void
}

/** One file of several sounds: its parts are found, shown, and made variations of a cue; the file itself is kept. */
export function SplitPanel(props: SplitPanelProps) {
  const { takeId } = props
  const { data: split } = useSplit(takeId)
  const finding = useFindParts(takeId)
  if (split === undefined) return null
  switch (split.state) {
    case 'making':
      return <p role="status">Finding the parts. The file itself is not changed.</p>
    case 'used':
      return <Used takeId={takeId} split={split} />
    case 'made':
      return (
        <div className="grid gap-3">
          <p className="mid">{split.says} Nothing is faded, and the file you sent is kept.</p>
          <Places key={split.shortest_pause_s} {...props} parts={split.parts} />
          {split.found_by === 'silence' && <ShortestPause split={split} finding={finding} />}
        </div>
      )
    default:
      return (
        <div className="grid gap-3">
          <p className="mid">{split.says}</p>
          {split.state === 'refused' && !split.is_our_fault ? (
            <ShortestPause split={split} finding={finding} />
          ) : (
            <>
              <div className="row wrap">
                <Button
                  disabled={!split.may_split || finding.isPending}
                  onClick={() => finding.mutate(split.shortest_pause_s)}
                >
                  Find the parts
                </Button>
                <span className="small mid">
                  By its markers, or else by its silences. You see them before anything changes.
                </span>
              </div>
              <Refusal error={finding.error} />
            </>
          )}
        </div>
      )
  }
}

function Used({ takeId, split }: { takeId: string; split: Split }) {
  const undo = useUndoSplit(takeId)
  const actionId = split.tray_action_id
  return (
    <div className="grid gap-3">
      <p className="mid">{split.says} They are variations now; this file is kept with the discarded ones.</p>
      {actionId !== null && (
        <div>
          <Button disabled={undo.isPending} onClick={() => undo.mutate(actionId)}>
            Undo the split
          </Button>
        </div>
      )}
      <Refusal error={undo.error} />
    </div>
  )
}

const LEFT_OUT = 0

/** The parts, and the variation that each becomes: in their order, until someone says otherwise. */
function Places({
  projectId,
  takeId,
  fileName,
  cueId: ownCueId,
  onHear,
  parts,
}: SplitPanelProps & { parts: readonly SplitPart[] }) {
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const [cueId, setCueId] = useState(ownCueId)
  const [chosen, setChosen] = useState<Record<number, number>>({})
  const using = useUseSplit(takeId)
  const undo = useUndoSplit(takeId)
  const cue = cues?.find(({ id }) => id === cueId)
  const variations = cue?.stems.length ?? 0
  const variationOf = ({ number }: SplitPart) => chosen[number] ?? (number <= variations ? number : LEFT_OUT)
  const places = parts
    .map((part) => ({ part: part.number, variation: variationOf(part) }))
    .filter(({ variation }) => variation !== LEFT_OUT)
  const leftOut = parts.length - places.length
  const isTwice = new Set(places.map(({ variation }) => variation)).size < places.length
  const use = () =>
    using.mutate(
      { cue_id: cueId, places },
      {
        onSuccess: (action) =>
          showToast(`${fileName} is ${plural(places.length, 'variation')} of ${cue?.name}.`, async () => {
            const { left } = await undo.mutateAsync(action.id)
            if (left > 0) showToast(`${plural(left, 'file')} changed since then and stayed.`)
          }),
      },
    )
  return (
    <>
      <Select
        label="Cue of the parts"
        value={cueId ?? ''}
        onChange={({ currentTarget }) => {
          setCueId(currentTarget.value || null)
          setChosen({})
        }}
      >
        <option value="">Choose a cue</option>
        {cues?.map(({ id, label, name, stems }) => (
          <option key={id} value={id}>
            {label} {name}, {plural(stems.length, 'variation')}
          </option>
        ))}
      </Select>
      <Parts
        parts={parts}
        onHear={onHear}
        choice={(part) => (
          <Select
            aria-label={`Variation of part ${part.number}`}
            value={variationOf(part)}
            disabled={variations === 0}
            onChange={({ currentTarget }) => setChosen({ ...chosen, [part.number]: Number(currentTarget.value) })}
          >
            <option value={LEFT_OUT}>Left out</option>
            {Array.from({ length: variations }, (_, index) => (
              <option key={index} value={index + 1}>
                Variation {index + 1}
              </option>
            ))}
          </Select>
        )}
      />
      {isTwice && <p role="alert">Two parts have the same variation. Choose another one, or leave one out.</p>}
      <Refusal error={using.error ?? undo.error} />
      <div className="row wrap">
        <Button variant="primary" disabled={places.length === 0 || isTwice || using.isPending} onClick={use}>
          {places.length === 0 ? 'Split into variations' : `Split into ${plural(places.length, 'variation')}`}
        </Button>
        {cue && leftOut > 0 && (
          <span className="small mid">
            {plural(leftOut, 'part')} left out
            {parts.length > variations && `: the cue has ${plural(variations, 'variation')}`}.
          </span>
        )}
      </div>
    </>
  )
}

interface PartsProps {
  parts: readonly SplitPart[]
  onHear?: (fromS: number) => void
  choice: (part: SplitPart) => ReactNode
}

function Parts({ parts, onHear, choice }: PartsProps) {
  const columns: Column<SplitPart>[] = [
    { head: 'Part', rowHead: true, cell: ({ number, label }) => (label ? `${number} ${label}` : number) },
    {
      head: 'Start',
      numeric: true,
      cell: ({ number, start_s: startS }) =>
        onHear ? (
          <button type="button" className="link" aria-label={`Play part ${number}`} onClick={() => onHear(startS)}>
            {place(startS)}
          </button>
        ) : (
          place(startS)
        ),
    },
    { head: 'Length', numeric: true, cell: ({ duration_s: durationS }) => place(durationS) },
    { head: 'Becomes', cell: choice },
  ]
  return <Table label="Parts" columns={columns} rows={parts} keyOf={({ number }) => number} />
}

/** How long silence has to be to part two sounds. */
function ShortestPause({ split, finding }: { split: Split; finding: ReturnType<typeof useFindParts> }) {
  return (
    <Form
      className="row wrap items-end"
      initialValues={{ pause_s: split.shortest_pause_s }}
      mutation={finding}
      onSubmit={({ pause_s }) => finding.mutate(pause_s)}
    >
      <Field
        as={NumberInput}
        name="pause_s"
        label="Silence between parts, at least (s)"
        min={0.05}
        max={10}
        step={0.1}
        decimalScale={2}
      />
      <Submit variant="plain">Find the parts again</Submit>
    </Form>
  )
}
