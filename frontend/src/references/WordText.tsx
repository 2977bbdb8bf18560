import { useQuery } from '@tanstack/react-query'
import { Fragment, useState } from 'react'

import { useLazy } from '@/ui/useLazy'

import { type Reference, wordListQuery } from './api'
import classes from './References.module.css'
import { partsOf } from './wordParts'

const load = () => import('./WordSound').then((part) => part.WordSound)

interface WordTextProps {
  projectId: string
  text: string
}

/** A text whose words of the project's list play the sound that shows what they mean. */
export function WordText({ projectId, text }: WordTextProps) {
  const { data: list } = useQuery(wordListQuery(projectId))
  const [heard, setHeard] = useState<Reference | null>(null)
  const WordSound = useLazy(load, heard !== null)
  const parts = partsOf(text, list ?? [])
  return (
    <>
      {parts.map(({ text: piece, reference }, at) =>
        reference ? (
          <WordButton key={at} word={piece} reference={reference} heard={heard} onHear={setHeard} />
        ) : (
          <Fragment key={at}>{piece}</Fragment>
        ),
      )}
      {heard && WordSound && <WordSound key={heard.id} reference={heard} />}
    </>
  )
}

/** The words of the list in a text that is being written, to hear them before they are sent; nothing without one. */
export function WordList({ projectId, text }: WordTextProps) {
  const { data: list } = useQuery(wordListQuery(projectId))
  const [heard, setHeard] = useState<Reference | null>(null)
  const WordSound = useLazy(load, heard !== null)
  const parts = partsOf(text, list ?? []).filter(({ reference }) => reference !== undefined)
  const words = [...new Map(parts.map((part) => [part.text.toLowerCase(), part.reference])).entries()]
  if (words.length === 0) return null
  return (
    <div className="small mid" role="group" aria-label="Words of the project">
      Hear what is meant by{' '}
      {words.map(([word, reference], at) => (
        <Fragment key={word}>
          {at > 0 && ', '}
          {reference && <WordButton word={word} reference={reference} heard={heard} onHear={setHeard} />}
        </Fragment>
      ))}
      {heard && WordSound && <WordSound key={heard.id} reference={heard} />}
    </div>
  )
}

interface WordButtonProps {
  word: string
  reference: Reference
  heard: Reference | null
  onHear: (reference: Reference | null) => void
}

function WordButton({ word, reference, heard, onHear }: WordButtonProps) {
  const isHeard = heard?.id === reference.id
  return (
    <button
      type="button"
      className={`p-0 border-0 bg-none pointer ${classes.word}`}
      aria-expanded={isHeard}
      aria-label={`Hear “${word}”`}
      title={reference.caption}
      onClick={() => onHear(isHeard ? null : reference)}
    >
      {word}
    </button>
  )
}
