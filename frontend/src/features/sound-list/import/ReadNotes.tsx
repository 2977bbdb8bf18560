import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural, rate } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'
import { Select } from '@/ui/Select'

import type { ImportRead } from './api'
import classes from './Import.module.css'
import type { SheetReading } from './pasted'

const SHOWN = 8
const ENCODINGS = ['utf-8', 'windows-1252', 'mac-roman', 'shift-jis', 'gb18030', 'big5', 'euc-kr', 'euc-jp', 'utf-16']
const RATES = [24, 25, 29.97, 30, 50, 60, 120]
const USUAL_SAMPLE_RATE = 48_000 // as the server reads them, unless it is told another
const SAMPLE_RATES = [44_100, 48_000, 88_200, 96_000, 192_000]
interface Props {
  read: ImportRead
  reading: SheetReading
  onRead: (reading: SheetReading) => void
}

/** What was guessed and not read, each with its reason and the way back. */
export function ReadNotes({ read, reading, onRead }: Props) {
  const { tabs, encoding, skipped, guesses, unread } = read
  const asksForRate = unread.some(({ why }) => why.includes('say the frame rate'))
  const inSamples =
    read.columns.some(({ why }) => why.includes('in samples')) || guesses.some(({ why }) => / Hz$/.test(why))
  const asksForOrder = read.errors.some(({ message }) => message.includes(' could be '))
  const others = tabs.filter(({ is_read, rows }) => !is_read && rows > 0)
  const filledDown = guesses.some(({ kind }) => kind === 'filled_down')
  const hides = skipped.some(({ kind }) => kind === 'hidden') || unread.some(({ is_kept }) => !is_kept)
  const asksAnything = asksForRate || inSamples || asksForOrder || filledDown || hides || reading.keep_hidden === true
  if (
    others.length + guesses.length + unread.length === 0 &&
    !encoding?.is_guess &&
    !asksAnything &&
    Object.keys(reading).length === 0
  ) {
    return null
  }
  return (
    <Card aria-labelledby="how-read">
      <CardHead id="how-read" title="How the sheet was read" note="Guesses, and columns that were left out" />
      <div className={`grid gap-3 wrap-anywhere p-3-4-4 ${classes.notes}`}>
        {tabs.length > 1 && (
          <div>
            <Segmented
              label="Tab"
              value={tabs.find(({ is_read }) => is_read)?.name ?? ''}
              onChange={(tab) => onRead({ ...reading, tab, skip_rows: [], keep_rows: [] })}
              options={tabs.map(({ name, rows, is_hidden }) => ({
                value: name,
                label: `${name} (${plural(rows, 'row')}${is_hidden ? ', hidden' : ''})`,
              }))}
            />
            {others.length > 0 && (
              <span className="small mid">
                Not read: {others.map(({ name }) => name).join(', ')}. Import {others.length === 1 ? 'it' : 'them'}{' '}
                next.
              </span>
            )}
          </div>
        )}
        {encoding && (encoding.is_guess || reading.encoding) && (
          <label>
            <span className="strong">Encoding{encoding.is_guess ? ', guessed from the letters' : ''}</span>
            <Select
              value={encoding.name}
              onChange={(event) => onRead({ ...reading, encoding: event.currentTarget.value })}
            >
              {[...new Set([encoding.name, ...encoding.others, ...ENCODINGS])].map((name) => (
                <option key={name}>{name}</option>
              ))}
            </Select>
          </label>
        )}
        {(asksForRate || reading.frame_rate_fps) && (
          <label>
            <span className="strong">Frame rate of lengths in frames</span>
            <Select
              value={String(reading.frame_rate_fps ?? '')}
              onChange={(event) => onRead({ ...reading, frame_rate_fps: Number(event.currentTarget.value) || null })}
            >
              <option value="">Not known: lengths are not read</option>
              {RATES.map((rate) => (
                <option key={rate} value={rate}>{`${rate} fps`}</option>
              ))}
            </Select>
          </label>
        )}
        {(inSamples || reading.sample_rate_hz) && (
          <label>
            <span className="strong">Sample rate of lengths in samples</span>
            <Select
              value={String(reading.sample_rate_hz ?? USUAL_SAMPLE_RATE)}
              onChange={(event) => onRead({ ...reading, sample_rate_hz: Number(event.currentTarget.value) })}
            >
              {SAMPLE_RATES.map((hz) => (
                <option key={hz} value={hz}>
                  {rate(hz)}
                </option>
              ))}
            </Select>
          </label>
        )}
        {(asksForOrder || reading.day_first != null) && (
          <Select
            label="Dates such as 4/5/2026"
            value={reading.day_first == null ? '' : String(reading.day_first)}
            onChange={({ currentTarget: { value } }) =>
              onRead({ ...reading, day_first: value === '' ? null : value === 'true' })
            }
          >
            <option value="">Could be either</option>
            <option value="true">Day first: 4 May</option>
            <option value="false">Month first: April 5</option>
          </Select>
        )}
        {(filledDown || reading.fill_down === false) && (
          <label className="row">
            <input
              type="checkbox"
              checked={reading.fill_down !== false}
              onChange={(event) => onRead({ ...reading, fill_down: event.currentTarget.checked })}
            />
            Fill down merged cells, and categories from titles of sections
          </label>
        )}
        {(hides || reading.keep_hidden === true) && (
          <label className="row">
            <input
              type="checkbox"
              checked={reading.keep_hidden === true}
              onChange={(event) => onRead({ ...reading, keep_hidden: event.currentTarget.checked })}
            />
            Read hidden rows and columns
          </label>
        )}
        {(read.refused_names.names.some(({ proposed }) => proposed) || reading.use_proposed_names === true) && (
          <label className="row">
            <input
              type="checkbox"
              checked={reading.use_proposed_names === true}
              onChange={(event) => onRead({ ...reading, use_proposed_names: event.currentTarget.checked })}
            />
            Rename files that the delivery spec refuses
          </label>
        )}
        <Notes title={`${plural(guesses.length, 'cell')} read by a guess`} count={guesses.length}>
          {(limit) =>
            guesses.slice(0, limit).map(({ row, column, text, value, why }, place) => (
              <li key={place}>
                <span className="mono dim">{row}</span> <span className="strong">{column}</span>
                {`: ${text === '' ? 'empty' : text} → ${value === '' ? 'empty' : value} `}
                <span className="mid">{why}</span>
              </li>
            ))
          }
        </Notes>
        <Notes title={`${plural(unread.length, 'column')} not read`} count={unread.length}>
          {(limit) =>
            unread.slice(0, limit).map(({ name, cells, is_kept, why }) => (
              <li key={name}>
                <span className="strong">{name}</span>
                {` (${plural(cells, 'cell')}, ${is_kept ? 'kept as it is' : 'left out'}): `}
                <span className="mid">{why}</span>
              </li>
            ))
          }
        </Notes>
      </div>
    </Card>
  )
}

interface NotesProps {
  title: string
  count: number
  children: (limit: number) => React.ReactNode
}

function Notes({ title, count, children }: NotesProps) {
  const [all, setAll] = useState(false)
  if (count === 0) return null
  return (
    <section aria-label={title}>
      <h3>{title}</h3>
      <ul className="small">{children(all ? count : SHOWN)}</ul>
      {count > SHOWN && !all && <Button onClick={() => setAll(true)}>{`Show all ${count}`}</Button>}
    </section>
  )
}
