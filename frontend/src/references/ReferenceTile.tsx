import { type ReactNode, useEffect, useEffectEvent, useState } from 'react'

import { Icon } from '@/ui/Icon'
import { Refusal } from '@/ui/Refusal'

import { partOf, type Reference, useOpenVersion } from './api'
import classes from './References.module.css'
import { factsOf, fragmentOf, kindIcon, titleOf } from './words'

interface ReferenceTileProps {
  reference: Reference
  /** Show a picture or a text in full. */
  onShow: (reference: Reference) => void
  /** A sound plays at once. */
  plays?: boolean
  /** Below its facts. */
  children?: ReactNode
}

/** One reference, seen or played in place, always with its terms. */
export function ReferenceTile({ reference, onShow, plays = false, children }: ReferenceTileProps) {
  const { version, terms } = reference
  const [isPlaying, setPlaying] = useState(false)
  const [isUnplayable, setUnplayable] = useState(false)
  const open = useOpenVersion(reference.project_id)
  const title = titleOf(reference)
  const excerpt = version.excerpt.slice(0, 400)
  const opened = (then: () => void) => open.mutate(version.id, { onSuccess: then })
  const begin = useEffectEvent(() => {
    if (plays && (version.kind === 'audio' || version.kind === 'video')) opened(() => setPlaying(true))
  })
  useEffect(() => begin(), [])
  const url = `${partOf(version.id, 'file')}${fragmentOf(reference)}`
  const played = {
    controls: true,
    autoPlay: true,
    src: url,
    className: classes.player,
    'aria-label': title,
    onError: () => setUnplayable(true),
  }
  const act = (label: string, run: () => void, inside: ReactNode) => (
    <button
      type="button"
      className={`grid pointer overflow-hidden relative w-full p-0 border-line-2 rounded bg-surface ink font-inherit ${classes.th}`}
      aria-label={`${label} ${title}${excerpt && `: ${excerpt}`}`}
      onClick={run}
    >
      {inside}
    </button>
  )
  const sign = (
    <span className={`grid bg-raised ${classes.sign}`}>
      <Icon name={kindIcon(version.kind)} />
    </span>
  )
  const download = () => opened(() => window.location.assign(`${partOf(version.id, 'file')}?download=true`))
  const shown = () => {
    switch (version.kind) {
      case 'picture':
        if (version.preview === 'made') {
          const picture = <img src={partOf(version.id, 'thumb')} alt="" loading="lazy" />
          return act('Show', () => opened(() => onShow(reference)), picture)
        }
        return act(
          'Download',
          download,
          <span className="mid wrap-anywhere p-3 text-small leading-small">
            {version.preview === 'pending' ? 'The preview is being made.' : `No preview: ${version.problem}.`}
          </span>,
        )
      case 'text':
        return act(
          'Read',
          () => opened(() => onShow(reference)),
          <span className={`overflow-hidden pre-line w-full wrap-anywhere ${classes.excerpt}`}>{excerpt}</span>,
        )
      case 'video':
      case 'audio':
        if (isUnplayable) {
          return act(
            'Download',
            download,
            <span className="mid wrap-anywhere p-3 text-small leading-small">This browser can’t play it.</span>,
          )
        }
        if (!isPlaying) return act('Play', () => opened(() => setPlaying(true)), sign)
        // What was sent comes as it is, without captions.
        /* eslint-disable jsx-a11y/media-has-caption */
        return (
          <div
            className={`grid pointer overflow-hidden relative w-full p-0 border-line-2 rounded bg-surface ink font-inherit ${classes.th}`}
          >
            {version.kind === 'video' ? <video {...played} /> : <audio {...played} />}
          </div>
        )
      /* eslint-enable jsx-a11y/media-has-caption */
      case 'link':
        return (
          <a
            className={`grid pointer overflow-hidden relative w-full p-0 border-line-2 rounded bg-surface ink font-inherit ${classes.th}`}
            href={version.url ?? undefined}
            target="_blank"
            rel="noreferrer noopener"
            aria-label={`Open ${title} at ${version.file_name} in a new tab`}
            onClick={() => open.mutate(version.id)}
          >
            {sign}
          </a>
        )
      default:
        return act('Download', download, sign)
    }
  }
  return (
    <article className={`grid gap-2 min-w-0 ${classes.tile}`} aria-label={title} data-reference={reference.id}>
      {shown()}
      <div className="grid content-start gap-2px min-w-0 wrap-anywhere">
        <p className="strong">{title}</p>
        <p className="small dim">{factsOf(reference)}</p>
        {terms && (
          <p className={`small tone-warn flex items-start gap-1 toned ${classes.terms}`}>
            <Icon name="triangle" />
            <span>
              <span className="visually-hidden">Terms: </span>
              {terms}
            </span>
          </p>
        )}
        <Refusal error={open.error} />
        {children}
      </div>
    </article>
  )
}
