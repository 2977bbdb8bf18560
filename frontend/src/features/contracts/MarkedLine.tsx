import type { Compared } from './api'
import classes from './Contracts.module.css'

interface MarkedLineProps {
  line: Compared
  /** The tag of a head, by the heads around it. */
  head?: 'h3' | 'h4'
}

/** One line of a text with what was struck and inserted in it. */
export function MarkedLine({ line, head: Head = 'h3' }: MarkedLineProps) {
  const said = line.runs.map(({ is_in, text }, index) =>
    is_in === 'later' ? <ins key={index}>{text}</ins> : is_in === 'earlier' ? <del key={index}>{text}</del> : text,
  )
  const className = line.change === 'same' ? undefined : classes.changed
  if (line.kind === 'head') return <Head className={className}>{said}</Head>
  return <p className={line.kind === 'item' ? `${classes.item} ${className ?? ''}` : className}>{said}</p>
}
