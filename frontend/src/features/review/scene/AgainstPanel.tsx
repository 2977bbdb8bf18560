import { useQuery } from '@tanstack/react-query'
import { useEffect, useMemo, useState } from 'react'

import { HotkeyButton } from '@/app/keys'
import type { Player, PlayerState, Source } from '@/audio'
import { useSounds } from '@/fixing'
import type { CueReview, ReviewTake } from '@/verdicts/api'
import { Refusal } from '@/ui/Refusal'
import { figure, gain, level } from '@/ui/format'
import { Select } from '@/ui/Select'

import { type Against, bedSourcesQuery, type Comparison, comparisonQuery } from './api'
import classes from './Scene.module.css'
import { SpectraPlot } from './SpectraPlot'

export interface AgainstPanelProps {
  review: CueReview
  projectId: string
  hand: ReviewTake
  nameOf: (take: ReviewTake) => string
  source: Source | null
  player: Player
  playing: PlayerState
}

interface Choice {
  key: string
  words: string
  against: Against
}

const DIFFERENCE = 'difference'
const OTHER = 'against'

/** A version against another sound: flipped at the same place, and what differs as figures, picture and track. */
export function AgainstPanel({ review, projectId, hand, nameOf, source, player, playing }: AgainstPanelProps) {
  const approved = useQuery(bedSourcesQuery(projectId))
  const choices = useMemo((): Choice[] => {
    const own = review.takes.filter(({ id, preview_url }) => id !== hand.id && preview_url !== null)
    const known = new Set(review.takes.map(({ id }) => id))
    return [
      ...own.map((take) => ofTake(take.id, `${nameOf(take)}${stateOf(take)}`)),
      ...hand.renders
        .filter(({ preview_url }) => preview_url !== null)
        .map(({ target }) => ({ key: `target ${target}`, words: `its file for ${target}`, against: { target } })),
      ...(approved.data ?? []).flatMap(({ take_id, name }) =>
        take_id !== null && !known.has(take_id) ? [ofTake(take_id, `approved: ${name}`)] : [],
      ),
    ]
  }, [review.takes, hand, nameOf, approved.data])
  const [key, setKey] = useState('')
  const chosen = choices.find((choice) => choice.key === key) ?? choices[0]
  const otherId = chosen?.against.against_take_id ?? hand.id
  const { data: sounds } = useSounds(otherId)
  const { data: comparison, error } = useQuery(comparisonQuery(hand.id, chosen?.against ?? null))
  const target = chosen?.against.target
  const otherSound = target ? sounds?.renders.find((render) => render.target === target) : sounds?.master
  const url = otherSound?.preview_url ?? null
  const heardId = playing.sourceId ?? ''
  const hear = (id: string, from: string | null, gainDb = 0) => {
    if (source === null || from === null) return
    const isHeard = heardId.startsWith(id)
    const takeId = id === OTHER ? otherId : undefined
    const to = { ...source, id: `${id} ${from}`, takeId, url: from, matchGainDb: (source.matchGainDb ?? 0) + gainDb }
    void player.select(isHeard ? source : to).then(() => (player.isPlaying() ? undefined : player.play()))
  }
  useEffect(
    () => () => {
      if (source !== null) void player.select(source)
    },
    [player, source, key],
  )
  if (chosen === undefined) {
    return <p className={`small mid ${classes.waits}`}>There is no other version, game file or approved sound yet.</p>
  }
  return (
    <section className={`grid gap-2 ${classes.against}`} aria-label="Against">
      <div className="flex wrap items-end gap-2">
        <Select label="Against" value={chosen.key} onChange={(event) => setKey(event.currentTarget.value)}>
          {choices.map((choice) => (
            <option key={choice.key} value={choice.key}>
              {choice.words}
            </option>
          ))}
        </Select>
        <HotkeyButton
          keys="b"
          keyLabel="Switch to what it stands against, at the same position"
          keyGroup="Review"
          icon="ab"
          pressed={heardId.startsWith(OTHER)}
          disabled={url === null}
          onPress={() => hear(OTHER, url, comparison?.gain_db ?? 0)}
        >
          {nameOf(hand)} ⇄ {chosen.words}
        </HotkeyButton>
        <HotkeyButton
          keys="shift+d"
          keyLabel="Hear the difference alone"
          keyGroup="Review"
          pressed={heardId.startsWith(DIFFERENCE)}
          disabled={!comparison?.file_url}
          onPress={() => hear(DIFFERENCE, comparison?.file_url ?? null)}
        >
          Difference
        </HotkeyButton>
      </div>
      <Refusal error={error} />
      {comparison && <p className="small mid">{inWords(comparison)}</p>}
      {comparison?.spectra && <SpectraPlot spectra={comparison.spectra} name={nameOf(hand)} other={chosen.words} />}
    </section>
  )
}

const ofTake = (id: string, words: string): Choice => ({ key: id, words, against: { against_take_id: id } })

const stateOf = ({ state }: ReviewTake): string =>
  state === 'approved' ? ', approved' : state === 'change_requested' ? ', change requested' : ''

/** How far two sounds differ: nothing of it is a verdict. */
function inWords({ is_made, refusal, residue_db, lag_s, gain_db }: Comparison): string {
  if (refusal !== null) return `They could not be compared: ${refusal}.`
  if (!is_made) return 'The difference is being made.'
  const moved =
    Math.abs(lag_s ?? 0) < 0.000_01 ? 'Both begin together' : `Aligned by ${figure((lag_s ?? 0) * 1000, 2)} ms`
  const levelled = Math.abs(gain_db ?? 0) < 0.05 ? 'at the same level' : `level matched by ${gain(gain_db ?? 0)}`
  if (residue_db === null) return 'The version is silent.'
  if (residue_db < -60) return `${moved}, ${levelled}. Nothing else differs (${level(residue_db)}).`
  return `${moved}, ${levelled}. The difference is ${level(residue_db)} relative to the version.`
}
