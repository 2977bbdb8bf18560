import { useQueryClient } from '@tanstack/react-query'
import { useCallback, useEffect, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { invalidate } from '@/api/queryKeys'
import { useDraft } from '@/app/drafts'

import { type AnswerWrite, type Brief, briefQuery, type Question, useSaveAnswers } from './api'

const SAVE_AFTER_MS = 700
const AGAIN_AFTER_MS = 5_000

/** An answer that is typed and not saved yet, and the revision of the brief that it began from. */
interface Pending extends AnswerWrite {
  from: number
}

export type Saving = 'saved' | 'saving' | 'lost' | 'refused'

export interface Answers {
  /** The answer as it is shown: typed, or as the server has it. */
  of: (question: Question) => AnswerWrite | null
  change: (question: Question, answer: Partial<AnswerWrite>) => void
  /** What the server said against one answer. */
  against: (key: string) => { message: string; isConflict: boolean } | null
  useTheirs: (key: string) => void
  useMine: (key: string) => void
  saving: Saving
}

const same = (a: AnswerWrite, b: AnswerWrite) =>
  JSON.stringify([a.value, a.is_unknown, a.note]) === JSON.stringify([b.value, b.is_unknown, b.note])

const NOTHING: AnswerWrite = { value: null, is_unknown: false, note: '' }

/** Saves answers as they are typed. What is not saved yet is kept in the browser, and sent again. */
export function useAnswers(projectId: string, brief: Brief): Answers {
  const client = useQueryClient()
  const [pending, setPending] = useDraft<Record<string, Pending>>(`brief:${projectId}`, {})
  const [faults, setFaults] = useState<Record<string, { message: string; isConflict: boolean }>>({})
  const [isLost, setLost] = useState(false)
  const [retries, setRetries] = useState(0)
  const save = useSaveAnswers(projectId)
  const inFlight = useRef(false)

  const sendable = Object.entries(pending).filter(([key]) => faults[key] === undefined)
  const latest = useRef(sendable)
  latest.current = sendable

  const { mutateAsync } = save
  const send = useCallback(async () => {
    const entries = latest.current
    if (inFlight.current || entries.length === 0) return
    inFlight.current = true
    const answers = Object.fromEntries(
      entries.map(([key, { value, is_unknown, note }]) => [key, { value, is_unknown, note }]),
    )
    try {
      const saved = await mutateAsync({ revision: Math.min(...entries.map(([, { from }]) => from)), answers })
      setLost(false)
      setPending((now) => {
        const left = Object.entries(now).filter(([key, answer]) => {
          const sent = answers[key]
          return sent === undefined || !same(answer, sent)
        })
        // What was typed on since begins from what was just saved.
        return Object.fromEntries(
          left.map(([key, answer]) => [key, key in answers ? { ...answer, from: saved.revision } : answer]),
        )
      })
    } catch (error) {
      if (error instanceof ApiProblem && error.status !== 0 && error.status < 500 && error.errors.length > 0) {
        const isConflict = error.code === 'answer-changed'
        setFaults((now) => ({
          ...now,
          ...Object.fromEntries(error.errors.map(({ field, message }) => [field, { message, isConflict }])),
        }))
        if (isConflict) await invalidate(client, briefQuery(projectId).queryKey)
      } else {
        setLost(true)
        setTimeout(() => setRetries((count) => count + 1), AGAIN_AFTER_MS)
      }
    } finally {
      inFlight.current = false
      setRetries((count) => count + 1)
    }
  }, [client, mutateAsync, projectId, setPending])

  const waiting = JSON.stringify(sendable)
  useEffect(() => {
    if (waiting === '[]') return
    const timer = setTimeout(() => void send(), SAVE_AFTER_MS)
    return () => clearTimeout(timer)
  }, [waiting, send, retries])

  const without = <T>(table: Record<string, T>, key: string): Record<string, T> =>
    Object.fromEntries(Object.entries(table).filter(([name]) => name !== key))

  const of = (question: Question): AnswerWrite | null => pending[question.key] ?? question.answer
  return {
    of,
    change: (question, answer) => {
      setFaults((now) => without(now, question.key))
      setPending((now) => {
        const old = now[question.key]
        const shown = old ?? question.answer ?? NOTHING
        const next = { value: shown.value, is_unknown: shown.is_unknown, note: shown.note, ...answer }
        return { ...now, [question.key]: { ...next, from: old?.from ?? brief.revision } }
      })
    },
    against: (key) => faults[key] ?? null,
    useTheirs: (key) => {
      setFaults((now) => without(now, key))
      setPending((now) => without(now, key))
    },
    useMine: (key) => {
      setFaults((now) => without(now, key))
      setPending((now) => {
        const mine = now[key]
        return mine ? { ...now, [key]: { ...mine, from: brief.revision } } : now
      })
    },
    saving: Object.keys(faults).length > 0 ? 'refused' : isLost ? 'lost' : sendable.length > 0 ? 'saving' : 'saved',
  }
}
