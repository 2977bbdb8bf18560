import type { ReactNode } from 'react'

import classes from './Icon.module.css'

/** Drawn on a grid of 16 with a line of 1.6. */
const SHAPES = {
  ring: <circle cx="8" cy="8" r="5.6" />,
  turning: (
    <>
      <circle cx="8" cy="8" r="5.8" opacity=".35" />
      <path d="M8 2.2A5.8 5.8 0 0 1 13.8 8" />
    </>
  ),
  bell: (
    <path d="M8 2.2a3.9 3.9 0 0 0-3.9 3.9c0 3.5-1.5 4.6-1.5 4.6h10.8s-1.5-1.1-1.5-4.6A3.9 3.9 0 0 0 8 2.2zM6.8 13.2a1.4 1.4 0 0 0 2.4 0" />
  ),
  headphones: (
    <>
      <path d="M2.8 10V8.2a5.2 5.2 0 0 1 10.4 0V10" />
      <rect x="2.2" y="9" width="2.6" height="4.2" rx="1" />
      <rect x="11.2" y="9" width="2.6" height="4.2" rx="1" />
    </>
  ),
  back: (
    <>
      <path d="M6 3.2 2.8 6.4 6 9.6" />
      <path d="M3 6.4h6.2a3.6 3.6 0 0 1 0 7.2H6" />
    </>
  ),
  turn: <path d="M5.6 3.2 2.8 6l2.8 2.8M3 6h6.5a3.5 3.5 0 0 1 0 7H7" />,
  question: (
    <>
      <circle cx="8" cy="8" r="6.2" />
      <path d="M6.2 6.5a1.8 1.8 0 1 1 3 1.4c-.8.6-1.2.9-1.2 1.7M8 11.6v.1" />
    </>
  ),
  triangle: <path d="M8 2.4l6 10.8H2zM8 6.6v3M8 11.4v.1" />,
  pencil: <path d="M3 13l.7-2.8 6.9-6.9a1.3 1.3 0 0 1 1.9 0l.3.3a1.3 1.3 0 0 1 0 1.9l-7 6.8zM9.6 4.3l2.2 2.2" />,
  tick: (
    <>
      <circle cx="8" cy="8" r="6.2" />
      <path d="M5.2 8.2l2 2 3.6-4.2" />
    </>
  ),
  spanner: (
    <path d="M10.6 2.8a3.2 3.2 0 0 0-3.7 4.2l-4.3 4.3 1.9 1.9L8.8 8.9A3.2 3.2 0 0 0 13 5.2l-2 2-1.9-.5-.5-1.9z" />
  ),
  dashedSquare: <rect x="2.6" y="2.6" width="10.8" height="10.8" rx="1.5" strokeDasharray="2.6 2.2" />,
  struckRing: (
    <>
      <path d="M3 8h10" />
      <circle cx="8" cy="8" r="6.2" strokeDasharray="1.5 2.4" />
    </>
  ),
  clock: (
    <>
      <circle cx="8" cy="8" r="6" />
      <path d="M8 4.6V8l2.4 1.6" />
    </>
  ),
  play: <path d="M5 3.2v9.6L12.6 8z" fill="currentColor" strokeWidth="1.2" />,
  pause: <path d="M5.5 3.5v9M10.5 3.5v9" strokeWidth="2.4" />,
  stop: <rect x="4" y="4" width="8" height="8" rx="1" fill="currentColor" strokeWidth="1.2" />,
  reverse: <path d="M11 3.2v9.6L3.4 8z" fill="currentColor" strokeWidth="1.2" />,
  loop: (
    <>
      <path d="M11.5 2.2l2 2-2 2M2.5 7.4v-.7A2.5 2.5 0 0 1 5 4.2h8.3" />
      <path d="M4.5 13.8l-2-2 2-2M13.5 8.6v.7a2.5 2.5 0 0 1-2.5 2.5H2.7" />
    </>
  ),
  ab: <path d="M2.3 12L5 4l2.7 8M3.2 9.6h3.6M9.9 4v8h2.2a2.1 2.1 0 1 0 0-4.2H9.9h1.9a1.9 1.9 0 1 0 0-3.8z" />,
  level: <path d="M3 13V8.5M6.3 13V3M9.7 13V6M13 13v-3" />,
  search: <path d="M7 2.6a4.4 4.4 0 1 0 0 8.8 4.4 4.4 0 1 0 0-8.8zM10.4 10.4l3.2 3.2" />,
  chevron: <path d="M4.5 6.3L8 9.8l3.5-3.5" />,
  right: <path d="M6.2 4.5L9.7 8l-3.5 3.5" />,
  plus: <path d="M8 3v10M3 8h10" />,
  cross: <path d="M4 4l8 8M12 4l-8 8" />,
  upload: <path d="M8 10.8V3M4.8 6L8 2.8 11.2 6M2.6 10.4v2.8h10.8v-2.8" />,
  download: <path d="M8 2.8v7.8M4.8 7.6L8 10.8l3.2-3.2M2.6 10.4v2.8h10.8v-2.8" />,
  copy: (
    <>
      <rect x="5.4" y="5.4" width="8" height="8" rx="1.2" />
      <path d="M10.4 5.2V3.8a1.2 1.2 0 0 0-1.2-1.2H3.8a1.2 1.2 0 0 0-1.2 1.2v5.4a1.2 1.2 0 0 0 1.2 1.2h1.4" />
    </>
  ),
  comment: <path d="M2.6 3.4h10.8v7.4H7.4L4.6 13v-2.2h-2z" />,
  file: <path d="M4 2h5l3 3v9H4zM9 2v3h3" />,
  box: <path d="M8 1.9l5.4 3v6.2L8 14.1l-5.4-3V4.9zM2.8 5L8 7.9 13.2 5M8 8v6" />,
  sun: (
    <>
      <circle cx="8" cy="8" r="2.8" />
      <path d="M8 1.8v1.4M8 12.8v1.4M1.8 8h1.4M12.8 8h1.4M3.7 3.7l1 1M11.3 11.3l1 1M12.3 3.7l-1 1M4.7 11.3l-1 1" />
    </>
  ),
  moon: <path d="M13 9.6A5.6 5.6 0 1 1 6.4 3a4.6 4.6 0 0 0 6.6 6.6z" />,
  lines: <path d="M2.5 4h11M2.5 8h7M2.5 12h9.5" />,
  sliders: (
    <>
      <path d="M2.5 5h5M11 5h2.5M2.5 11h2.5M8.5 11h5" />
      <circle cx="9.2" cy="5" r="1.7" />
      <circle cx="6.7" cy="11" r="1.7" />
    </>
  ),
  tray: <path d="M2 9.6h3.4l1 1.8h3.2l1-1.8H14M2 9.6V13h12V9.6L12 3.4H4z" />,
  people: (
    <>
      <circle cx="6" cy="5.4" r="2.4" />
      <path d="M1.8 13a4.2 4.2 0 0 1 8.4 0M10.6 3.2a2.4 2.4 0 0 1 0 4.4M11.8 9.2a4.2 4.2 0 0 1 2.4 3.8" />
    </>
  ),
  game: (
    <>
      <path d="M4.6 5h6.8a3 3 0 0 1 3 3.2l-.3 2.6a1.5 1.5 0 0 1-2.7.7L10.2 10H5.8l-1.2 1.5a1.5 1.5 0 0 1-2.7-.7l-.3-2.6A3 3 0 0 1 4.6 5z" />
      <path d="M5.2 6.9v1.8M4.3 7.8h1.8M10.8 7.8h.01" />
    </>
  ),
  more: <path d="M3.5 8h.01M8 8h.01M12.5 8h.01" strokeWidth="2.6" />,
  mail: <path d="M2.4 3.8h11.2v8.4H2.4zM2.6 4.2L8 8.6l5.4-4.4" />,
} as const satisfies Record<string, ReactNode>

export type IconName = keyof typeof SHAPES

/** One drawn sign. It never stands alone for a verdict: a word goes with it. */
export function Icon({ name, size = 16 }: { name: IconName; size?: number }) {
  return (
    <svg
      className={name === 'turning' ? `${classes.icon} ${classes.turning}` : classes.icon}
      viewBox="0 0 16 16"
      width={size}
      height={size}
      aria-hidden="true"
      focusable="false"
    >
      {SHAPES[name]}
    </svg>
  )
}
