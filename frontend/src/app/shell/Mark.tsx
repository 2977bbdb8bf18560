/** Five bars of a sound. */
export function Mark() {
  return (
    <svg viewBox="0 0 18 18" width="18" height="18" fill="currentColor" aria-hidden="true" focusable="false">
      <rect x="1" y="7" width="2.2" height="4" rx="1" />
      <rect x="4.5" y="3.5" width="2.2" height="11" rx="1" />
      <rect x="8" y="1" width="2.2" height="16" rx="1" />
      <rect x="11.5" y="5" width="2.2" height="8" rx="1" />
      <rect x="15" y="7.5" width="2.2" height="3" rx="1" />
    </svg>
  )
}
