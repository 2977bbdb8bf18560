import { useState } from 'react'

import classes from './Avatar.module.css'

interface AvatarProps {
  name: string
  /** The address of the person's picture. */
  picture?: string | null
  filled?: boolean
  /** As on the person's own page. */
  large?: boolean
}

/** A person's picture in a circle, or two letters: "Audio director" gives AD, "Producer" PR. */
export function Avatar({ name, picture, filled = false, large = false }: AvatarProps) {
  const [failed, setFailed] = useState<string>()
  const shape = [classes.face, filled && classes.filled, large && classes.large].filter(Boolean).join(' ')
  if (picture && picture !== failed) {
    return <img className={shape} src={picture} alt="" decoding="async" onError={() => setFailed(picture)} />
  }
  const words = name.trim().split(/\s+/)
  const letters = words.length > 1 ? words.slice(0, 2).map((word) => word.charAt(0)) : [name.trim().slice(0, 2)]
  return (
    <span className={shape} aria-hidden="true">
      {letters.join('').toUpperCase()}
    </span>
  )
}
