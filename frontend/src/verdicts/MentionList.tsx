import { useQuery } from '@tanstack/react-query'
import { useEffect, useId, useLayoutEffect, useRef, useState } from 'react'
import { flushSync } from 'react-dom'

import { Avatar } from '@/ui/Avatar'

import classes from './MentionList.module.css'
import { type Mentionable, mentionableQuery, type MentionsProps, offered, typedName } from './mentionNames'

const keepInSight = (list: HTMLElement | null) => list?.scrollIntoView({ block: 'nearest' })

/** The people whose name begins as typed: arrows move, Enter and Tab choose, Escape closes. */
export function MentionList({ takeId, field, text, onText }: MentionsProps) {
  const { data: people } = useQuery(mentionableQuery(takeId))
  const [caret, setCaret] = useState(() => field.current?.selectionStart ?? text.length)
  const [chosen, setChosen] = useState(0)
  /** Where the @ stands whose list was closed. */
  const [closedAt, setClosedAt] = useState<number | null>(null)
  const listId = useId()

  const typed = typedName(text, caret)
  const options = typed && people && typed.from !== closedAt ? offered(people, typed.query) : []
  // A name that is whole is offered no more, so that Enter sends.
  const isOpen = options.length > 0 && !options.some(({ name }) => typed?.query.trimEnd() === name)
  const at = Math.min(chosen, options.length - 1)

  const choose = (person: Mentionable) => {
    if (typed === null) return
    const before = `${text.slice(0, typed.from)}@${person.name} `
    flushSync(() => onText(before + text.slice(caret).trimStart()))
    field.current?.focus()
    field.current?.setSelectionRange(before.length, before.length)
    setCaret(before.length)
    setChosen(0)
  }
  const onKey = (event: KeyboardEvent) => {
    if (!isOpen || event.isComposing) return
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key]
    const person = options[at]
    if (by !== undefined) setChosen((at + by + options.length) % options.length)
    else if ((event.key === 'Enter' || event.key === 'Tab') && person && !event.ctrlKey && !event.metaKey)
      choose(person)
    else if (event.key === 'Escape') setClosedAt(typed?.from ?? null)
    else return
    // The field's own Enter sends, and its Escape closes.
    event.preventDefault()
    event.stopImmediatePropagation()
  }
  const newest = useRef(onKey)
  useLayoutEffect(() => {
    newest.current = onKey
  })
  useEffect(() => {
    const element = field.current
    if (!element) return
    const ending = new AbortController()
    const follow = () => setCaret(element.selectionStart ?? element.value.length)
    element.addEventListener('keydown', (event) => newest.current(event as KeyboardEvent), { signal: ending.signal })
    for (const sign of ['input', 'keyup', 'click']) element.addEventListener(sign, follow, { signal: ending.signal })
    follow()
    return () => ending.abort()
  }, [field])
  const active = isOpen ? `${listId}-${at}` : undefined
  useEffect(() => {
    const element = field.current
    if (!element || active === undefined) return
    element.setAttribute('aria-autocomplete', 'list')
    element.setAttribute('aria-controls', listId)
    element.setAttribute('aria-activedescendant', active)
    return () => {
      for (const name of ['aria-autocomplete', 'aria-controls', 'aria-activedescendant']) element.removeAttribute(name)
    }
  }, [active, field, listId])

  if (!isOpen) return null
  return (
    <div
      ref={keepInSight}
      id={listId}
      role="listbox"
      aria-label="People to mention"
      className={`bg-raised overflow-hidden mt-1 border-edge rounded ${classes.list}`}
    >
      {options.map((person, index) => (
        <div
          key={person.id}
          id={`${listId}-${index}`}
          role="option"
          aria-selected={index === at}
          className={`row hover min-h-28px pointer ${classes.option}`}
          onPointerDown={(event) => {
            event.preventDefault() // the field keeps the focus
            choose(person)
          }}
        >
          <Avatar name={person.name} picture={person.picture} />
          {person.name}
        </div>
      ))}
    </div>
  )
}
